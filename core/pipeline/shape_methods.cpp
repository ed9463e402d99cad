#include "core/decide/decide_ends.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/methods.h"
#include "core/radius/assigned_radii.h"
#include "core/radius/recenter_on_cylinders.h"
#include "core/skeleton/assemble_axes.h"
#include "core/skeleton/extend_ends.h"
#include "core/skeleton/foot_on_axis.h"
#include "core/skeleton/prune.h"
#include "core/skeleton/recenter.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// Of a plant that had many more ends than shoots, by the odds that are used by default, that it
/// has; else nothing.
std::optional<ShownMessage> noteOnEnds(const std::vector<EndDecision>& decisions,
                                       const EndOptions& options) {
  constexpr std::ptrdiff_t few = 25; // ends: of a small plant fewer stay
  constexpr std::ptrdiff_t many = 5; // times as many as stay
  const std::ptrdiff_t stay = std::ranges::count_if(decisions, &EndDecision::stays);
  const std::ptrdiff_t gone = std::ssize(decisions) - stay;
  if (options.leastProbability > EndOptions().leastProbability || stay < few || gone < many * stay)
    return std::nullopt;
  return ShownMessage{
      Shown::tr("%1 of %2 ends are removed, most of them probably edges of leaves or needles, and "
                "more of these may be left: for a herb or a seedling, try the settings Leaves "
                "(--preset leaves)"),
      {std::to_string(gone), std::to_string(decisions.size())}};
}

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
        const Options options = table.with(values);
        DecidedEnds decided =
            withDecidedEnds(*state.skeleton, keptPositions(state), state.cloud->origin(),
                            state.extent.scale, options, progress);
        state.setSkeleton(std::move(decided.skeleton));
        if (auto note = noteOnEnds(decided.decisions, options))
          state.notes.push_back(*std::move(note));
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
  return {
      .name = "to_points",
      .label = Shown::tr("Extend to the points"),
      .help = Shown::tr("Lengthens tips and roots to the points that contraction pulled inwards, "
                        "and lays the foot of thick wood on its axis."),
      .source = {},
      .options = {},
      .run = [](PipelineState& state, const Values&, const Progress& progress) {
        const Eigen::Matrix3Xf points = keptPositions(state);
        const Eigen::Vector3d origin = state.cloud->origin();
        state.setSkeleton(
            withExtendedEnds(withFootOnAxis(*state.skeleton, points, origin, progress.part(0, 0.5)),
                             points, origin, progress.part(0.5, 1)));
      }};
}

} // namespace

std::vector<Method> pruneMethods() {
  // Of 42 simulated scans that the odds were not fitted on (espalier_accuracy --plants any --seeds
  // 3): mean G, T, F within 4 spacings and segments found per true one; then of those with fewer
  // than 60 points a segment, and of those with foliage. The rows by probability alone have 2.5
  // spacings as their length; that of the default is the length of spurs.
  //
  //   default  .889 .729 .907 0.98   .818 .603 .908 0.86   .903 .700 .907 1.09
  //   spurs    .876 .722 .907 1.11   .801 .596 .909 0.97   .902 .697 .909 1.18
  //   0.3      .896 .724 .910 1.10   .847 .588 .921 0.95   .880 .713 .906 1.45
  //   0.5      .892 .732 .907 0.93   .838 .597 .915 0.79   .886 .702 .902 1.07
  //   0.6      .887 .729 .903 0.86   .826 .594 .909 0.72   .883 .686 .896 0.94
  //
  // By probability alone whole branches of a pine with dense needles go (of one, 22 % of its
  // segments are left at 0.6, 79 % by length), and most of a real crown in leaf (las/tree: 38 m
  // of 77), by other ends in each of its three formats. So the default takes away only what is
  // clearly no shoot. The preset for leaves goes farther.
  //
  // The odds were fitted on none of these, but this choice was made with them in sight: after 0.1
  // to 0.6 had been tried on these 42 scans, and on puu1, A3B4, las/tree and the leafy scans. So
  // none of them says how well it does on others.
  //
  // Not taken: odds half as high where the scan is sparse. By thin wood under 1.5 spacings, chosen
  // on 112 plants, of which it raised G of the sparse ones by 0.007, G of 15 sparse bare others is
  // 0.916 instead of 0.910, of 12 with foliage 0.852 instead of 0.850 (any --first 4001 --seeds 5);
  // but of 8 denser ones with foliage it is 0.925 instead of 0.934, and of 4 trees in leaf 0.886
  // instead of 0.900 (organs --first 1801 --seeds 4). By under 150 points a probable shoot, 4
  // shrubs in leaf lose 0.026, too.
  return {oddsMethod(), spurMethod(), noMethod(Shown::tr("Keeps all branches."))};
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
