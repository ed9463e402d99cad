#include "core/decide/decide_ends.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/methods.h"
#include "core/radius/assigned_radii.h"
#include "core/radius/recenter_on_cylinders.h"
#include "core/skeleton/assemble_axes.h"
#include "core/skeleton/extend_ends.h"
#include "core/skeleton/prune.h"
#include "core/skeleton/recenter.h"

namespace espalier {
namespace {

Method oddsMethod() {
  using Options = EndOptions;
  OptionTable<Options> table;
  table.add(ratioOption("least_odds", Shown::tr("Least probability"), 0, 1,
                        Shown::tr("Ends that are less probably shoots are removed; 0 keeps all "
                                  "that are long enough.")),
            &Options::leastProbability);
  table.add(lengthOption("length", Shown::tr("Length"), 0, 200,
                         Shown::tr("Unbranched ends shorter than this are removed.")),
            &Options::length);
  return {
      .name = "odds",
      .label = Shown::tr("By probability"),
      .help = Shown::tr("Removes ends that are probably no shoots, by how far they stand out, what "
                        "bears them, and the points that only they explain."),
      .source = "logistic regression: D. R. Cox, J. R. Stat. Soc. B 20, 1958",
      .options = table.descriptions(),
      .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
        DecidedEnds decided =
            withDecidedEnds(*state.skeleton, keptPositions(state), state.cloud->origin(),
                            state.extent.scale.spacing, table.with(values), progress);
        state.setSkeleton(std::move(decided.skeleton));
        state.ends = std::make_shared<const std::vector<EndDecision>>(std::move(decided.decisions));
      }};
}

Method spurMethod() {
  using Options = SpurOptions;
  OptionTable<Options> table;
  table.add(lengthOption("length", Shown::tr("Length"), 0, 200,
                         Shown::tr("Unbranched ends shorter than this are removed.")),
            &Options::length);
  table.add(
      ratioOption("radius_share", Shown::tr("Radius share"), 0, 10,
                  Shown::tr("This many radii of the wood they stand on are added to that length.")),
      &Options::radiusShare);
  return {.name = "spurs",
          .label = Shown::tr("Remove spurs"),
          .help = Shown::tr("Removes short unbranched ends, shortest first."),
          .source = {},
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            state.setSkeleton(withoutSpurs(*state.skeleton, table.with(values), progress));
          }};
}

Option recenterRoundsOption() {
  return countOption("rounds", Shown::tr("Rounds"), 0, 20,
                     Shown::tr("How often nodes are moved and smoothed."));
}

Option smoothingOption() {
  return ratioOption(
      "smoothing", Shown::tr("Smoothing"), 0, 1,
      Shown::tr("How far each node moves to the mean of its neighbors on the axis."));
}

void addTurnOptions(OptionTable<AxisOptions>& table) {
  using Options = AxisOptions;
  table.add(angleOption("sharpest_turn", Shown::tr("Sharpest turn"), 1, 180,
                        Shown::tr("An axis never turns more than this where it branches.")),
            &Options::sharpestTurn);
  table.add(
      countOption("reach", Shown::tr("Reach"), 1, 50,
                  Shown::tr("Edges before and behind a node over which its turn is measured.")),
      &Options::reach);
}

Method heaviestMethod() {
  OptionTable<AxisOptions> table;
  addTurnOptions(table);
  return {.name = "heaviest_child",
          .label = Shown::tr("Heaviest child"),
          .help = Shown::tr(
              "The child that carries most continues the axis, unless it turns off too sharply."),
          .source = "PlantScan3D's rule, by length instead of node count",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            state.setSkeleton(withAssembledAxes(*state.skeleton, table.with(values)));
          }};
}

Method weighedMethod() {
  using Options = AxisOptions;
  OptionTable<Options> table(weighedAxes);
  addTurnOptions(table);
  table.add(ratioOption("carried", Shown::tr("Weight of what it carries"), 0, 100,
                        Shown::tr("What a child loses per halving of the length that it carries.")),
            &Options::carried);
  table.add(ratioOption("straightness", Shown::tr("Weight of straightness"), 0, 100,
                        Shown::tr("What a child loses per turn by 60 degrees.")),
            &Options::straightness);
  table.add(ratioOption("thickness", Shown::tr("Weight of thickness"), 0, 100,
                        Shown::tr("What a child loses per halving of its radius.")),
            &Options::thickness);
  return {.name = "weighed",
          .label = Shown::tr("Weighed"),
          .help = Shown::tr(
              "The child that is heavy, straight and thick continues the axis, unless it turns "
              "off too sharply."),
          .source = {},
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const AxisOptions options = table.with(values);
            const std::vector<double> radii =
                options.thickness > 0 ? meanPointDistances(*state.skeleton, keptPositions(state),
                                                           state.cloud->origin(), progress)
                                      : std::vector<double>();
            progress.check();
            state.setSkeleton(withAssembledAxes(*state.skeleton, options, radii));
          }};
}

Method recenterMethod() {
  using Options = RecenterOptions;
  OptionTable<Options> table;
  table.add(recenterRoundsOption(), &Options::rounds);
  table.add(smoothingOption(), &Options::smoothing);
  table.add(
      ratioOption(
          "least_coverage", Shown::tr("Least coverage"), 0.1, 1,
          Shown::tr("Share of a circle that points must cover before a fitted circle is trusted.")),
      &Options::leastCoverage);
  table.add(
      ratioOption(
          "straight_reach", Shown::tr("Straight reach"), 0, 100,
          Shown::tr(
              "Between two trusted circles so near, in radii, wood is taken as straight: there "
              "branches pull nodes aside.")),
      &Options::straightReach);
  return {
      .name = "sections",
      .label = Shown::tr("Recenter on sections"),
      .help = Shown::tr(
          "Moves nodes to the centers of circles fitted to the wood around them and smooths the "
          "axes."),
      .source = "circle: G. Taubin, IEEE PAMI 13, 1991",
      .options = table.descriptions(),
      .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
        state.setSkeleton(recentered(*state.skeleton, keptPositions(state), state.cloud->origin(),
                                     table.with(values), progress));
      }};
}

Method cylinderRecenterMethod() {
  using Options = CylinderCenteringOptions;
  OptionTable<Options> table;
  table.add(recenterRoundsOption(), &Options::rounds);
  table.add(smoothingOption(), &Options::smoothing);
  table.add(coverageOption(), &Options::cylinders, &CylinderOptions::leastCoverage);
  table.add(cylinderLengthOption(), &Options::cylinders, &CylinderOptions::length);
  return {.name = "cylinders",
          .label = Shown::tr("Recenter on cylinders"),
          .help = Shown::tr(
              "Moves nodes onto the axes of cylinders fitted to the wood around them, which "
              "finds the middle of wood scanned from one side, and smooths the axes."),
          .source = "cylinder: G. Lukacs, R. Martin, D. Marshall, ECCV 1998",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            Options options = table.with(values);
            const Eigen::Matrix3Xf kept = keptPositions(state);
            options.cylinders.spacing = pointSpacing(kept, progress);
            state.setSkeleton(recenteredOnCylinders(*state.skeleton, kept, state.cloud->origin(),
                                                    options, progress));
          }};
}

Method endsMethod() {
  return {.name = "to_points",
          .label = Shown::tr("Extend to the points"),
          .help =
              Shown::tr("Lengthens tips and roots to the points that contraction pulled inwards."),
          .source = {},
          .options = {},
          .run = [](PipelineState& state, const Values&, const Progress& progress) {
            state.setSkeleton(withExtendedEnds(*state.skeleton, keptPositions(state),
                                               state.cloud->origin(), progress));
          }};
}

} // namespace

std::vector<Method> pruneMethods() {
  // G and T of 24 grown plants, bare and leafy, of 9 scans of structures, bare and leafy, of A3B4,
  // and of puu1 against its first structure by hand and against the later revision, by spacings:
  //
  //   14  .957 .861  .951 .827  .924 .900  .904 .852  .886 .919  .926 .842  .874 .867
  //   12  .960 .859  .957 .823  .939 .901  .920 .857  .907 .893  .921 .847  .891 .876
  //   11  .962 .862  .961 .828  .945 .902  .927 .858  .910 .894  .912 .840  .899 .870
  //   10  .964 .867  .966 .826  .949 .902  .933 .859  .914 .897  .894 .839  .900 .873
  //    8  .964 .865  .965 .824  .958 .903  .937 .856  .916 .889  .864 .835  .895 .857
  //
  // Simulated scans have fewer stray ends than a pine with its needles, so not the least that is
  // best for them. The first structure of puu1 draws a third fewer ends than its revision.
  //
  // What else distinguishes true short ends from stray ones adds little to their length: with
  // points per length, angle and straightness too the area under the curve is 0.78 to 0.90 instead
  // of 0.78 to 0.88, and 0.86 instead of 0.85 on puu1. Were all of them recognized, T of puu1 would
  // be 0.882 and that of leafy structures 0.036 more; that of grown plants stays.
  return {spurMethod(), oddsMethod(), noMethod(Shown::tr("Keeps all branches."))};
}

std::vector<Method> axesMethods() {
  // With straightness 6 and thickness 1, wood of the same axis is 0.87 of 12 grown plants and 0.80
  // of 6 scans of experts' structures; by what a child carries alone, 0.78 and 0.79.
  return {weighedMethod(), heaviestMethod()};
}

std::vector<Method> recenterMethods() {
  return {recenterMethod(), cylinderRecenterMethod(),
          noMethod(Shown::tr("Leaves the nodes where they are."))};
}

std::vector<Method> endsMethods() {
  // Without it F falls by 0.006 on leafy grown plants and by 0.009 on bare ones (4 seeds); on leafy
  // structures it rises by 0.003. Leaving out more than the farthest tenth of the points, to half
  // of them, changes F by less than 0.002 on all.
  return {endsMethod(), noMethod(Shown::tr("Leaves the ends where they are."))};
}

} // namespace espalier
