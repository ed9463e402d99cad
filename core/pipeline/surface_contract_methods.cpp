#include "core/contract/implicit_laplacian.h"
#include "core/contract/l1_medial.h"
#include "core/contract/one_step_laplacian.h"
#include "core/contract/path_based.h"
#include "core/contract/rotational_symmetry.h"
#include "core/pipeline/contract_parts.h"
#include "core/pipeline/methods.h"

#include <algorithm>

namespace espalier {
namespace {

struct OneStepOptions {
  int neighbors = 7;
};

Method oneStepLaplacianMethod() {
  OptionTable<OneStepOptions> table;
  table.add(linksOption(Shown::tr("How many of the nearest points each one moves to the mean of.")),
            &OneStepOptions::neighbors);
  return contractMethod<OneStepOptions>(
      {.name = "one_step_laplacian",
       .label = Shown::tr("One Laplacian step"),
       .help = Shown::tr("Moves each point to the mean of its nearest ones: a slight smoothing."),
       .inManual = Shown::tr("smoothing of noise, hardly a contraction"),
       .source = "Laplacian contraction of PlantScan3D"},
      table,
      [](const auto& points, const OneStepOptions& options, const auto&, const Progress& progress) {
        return contractedByOneLaplacianStep(points, options.neighbors, progress);
      },
      [](const OneStepOptions& options) { return probeOfNearest(options.neighbors); });
}

Method implicitLaplacianMethod() {
  using Options = ImplicitLaplacianOptions;
  OptionTable<Options> table;
  table.add(linksOption(Shown::tr(
                "How many of the nearest points the ring about each one is chosen from.")),
            &Options::neighbors);
  table.add(ratioOption("contraction", Shown::tr("Contraction"), 0.01, 100,
                        Shown::tr("Factor on the weight of contraction in the first round.")),
            &Options::contraction);
  table.add(ratioOption("growth", Shown::tr("Growth"), 1, 20,
                        Shown::tr("How much stronger each round contracts than the one before.")),
            &Options::growth);
  table.add(
      countOption("rounds", Shown::tr("Rounds"), 0, 20,
                  Shown::tr("How often the equations are solved; more of them shorten twigs.")),
      &Options::rounds);
  return contractMethod<Options>(
      {.name = "implicit_laplacian",
       .label = Shown::tr("Implicit Laplacian"),
       .help = Shown::tr(
           "Solves for places where the surface has shrunk to lines; bridges holes, is slow."),
       .inManual = Shown::tr(
           "scans with holes; clean lines where wood is thick. Shortens twigs; takes memory"),
       .source = "J. Cao et al., Point cloud skeletons via Laplacian based contraction, SMI 2010"},
      table,
      [](const auto& points, const Options& options, const auto&, const Progress& progress) {
        return contractedByImplicitLaplacian(points, options, progress);
      },
      [](const Options& options) { return probeOfNearest(options.neighbors); });
}

Option reachOption(const char* name, const char* label, const char* help) {
  return lengthOption(name, label, 0.5, 200, help);
}

Method l1MedialMethod() {
  using Options = L1MedialOptions;
  OptionTable<Options> table;
  table.add(ratioOption(
                "sample_share", Shown::tr("Samples"), 0.001, 1,
                Shown::tr("Share of the points that become samples; the others move with these.")),
            &Options::sampleShare);
  table.add(reachOption("first_radius", Shown::tr("First radius"),
                        Shown::tr("Neighborhoods of the first stage; each stage adds half of it.")),
            &Options::firstRadius);
  table.add(
      reachOption(
          "last_radius", Shown::tr("Last radius"),
          Shown::tr("No stage looks farther than this. More reaches the middle of thicker wood "
                    "and merges more twigs.")),
      &Options::lastRadius);
  table.add(
      countOption("stage_rounds", Shown::tr("Rounds per stage"), 1, 200,
                  Shown::tr("How often samples move in a stage, if they do not rest before.")),
      &Options::roundsPerStage);
  table.add(ratioOption(
                "repulsion", Shown::tr("Repulsion"), 0, 0.5,
                Shown::tr("How strongly samples push each other apart along the lines they form.")),
            &Options::repulsion);
  table.add(
      ratioOption(
          "least_direction", Shown::tr("Least direction"), 0.5, 1,
          Shown::tr("Share of their spread that must lie along a line before samples become a "
                    "branch and rest.")),
      &Options::leastDirection);
  return contractMethod<Options>(
      {.name = "l1_medial",
       .label = Shown::tr("L1 medial"),
       .help = Shown::tr(
           "Moves samples to medians of the points about them, while they push each other "
           "apart; bears holes, is slow."),
       .inManual = Shown::tr("scans with holes and strays; slow"),
       .source = "H. Huang et al., L1-medial skeleton of point cloud, ACM Trans. Graph. 32(4), "
                 "2013"},
      table,
      [](const auto& points, const Options& options, const auto&, const Progress& progress) {
        Options inOrder = options;
        inOrder.lastRadius = std::max<double>(inOrder.firstRadius, inOrder.lastRadius);
        return contractedToL1Medial(points, inOrder, progress);
      },
      [](const Options& options) {
        MethodProbe probe = probeWithin(options.lastRadius);
        probe.reach = std::max<double>(options.firstRadius, options.lastRadius);
        return probe;
      });
}

Method rotationalSymmetryMethod() {
  using Options = RotationalSymmetryOptions;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors, &PointLinks::count);
  table.add(countOption(
                "normal_neighbors", Shown::tr("Points of normals"), 3, 64,
                Shown::tr("How many of the nearest points the normal of each one is found from.")),
            &Options::normalNeighbors);
  table.add(reachOption("width", Shown::tr("Width"),
                        Shown::tr("Half of the thickness of a section, along the wood.")),
            &Options::width);
  table.add(reachOption(
                "reach", Shown::tr("Reach"),
                Shown::tr("How far a section goes across the wood; it need not reach around it.")),
            &Options::reach);
  table.add(countOption("axis_rounds", Shown::tr("Rounds"), 1, 20,
                        Shown::tr("How often sections and axes are found in turn.")),
            &Options::rounds);
  table.add(
      countOption(
          "smoothing", Shown::tr("Smoothing"), 0, 50,
          Shown::tr("How often places that normals do not determine follow their neighbors.")),
      &Options::smoothing);
  table.add(linkKindOption(), &Options::neighbors, &PointLinks::kind);
  return contractMethod<Options>(
      {.name = "rotational_symmetry",
       .label = Shown::tr("Rotational symmetry axes"),
       .help = Shown::tr(
           "Moves each point to where the normals of its section meet: the middle of round "
           "wood, of which only a part is seen."),
       .inManual = Shown::tr("clean, dense scans of round wood, from one side, too"),
       .source = "A. Tagliasacchi, H. Zhang, D. Cohen-Or, ACM Trans. Graph. 28(3), 2009 (ROSA)"},
      table,
      [](const auto& points, const Options& options, const auto&, const Progress& progress) {
        return contractedToSymmetryAxes(points, options, progress);
      },
      [](const Options& options) {
        MethodProbe probe = probeWithin(options.reach);
        probe.links = options.neighbors;
        probe.reach = std::max<double>(options.width, options.reach);
        return probe;
      });
}

/// The root of the plant among the points that were kept.
Eigen::Index keptRoot(const PipelineState& state) {
  const std::vector<Eigen::Index> kept = keptPoints(state);
  return std::lower_bound(kept.begin(), kept.end(), state.root) - kept.begin();
}

Method pathBasedMethod() {
  using Options = PathBasedOptions;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors, &PointLinks::count);
  table.add(
      countOption("rounds", Shown::tr("Rounds"), 0, 20, Shown::tr("How often paths are smoothed.")),
      &Options::rounds);
  table.add(linkKindOption(), &Options::neighbors, &PointLinks::kind);
  Method method = contractMethod<Options>(
      {.name = "path_based",
       .label = Shown::tr("Along paths"),
       .help =
           Shown::tr("Straightens the paths from all points to the root, twigs after the wood that "
                     "carries them."),
       .inManual = Shown::tr("smooth twigs of noisy scans; leaves thick wood nearly as it is"),
       .source = "Y. Livny et al., ACM Trans. Graph. 29(6), 2010"},
      table,
      [](const auto& points, const Options& options, const PipelineState& state,
         const Progress& progress) {
        return contractedAlongPaths(points, keptRoot(state), options, progress);
      },
      [](const Options& options) {
        return MethodProbe{.links = options.neighbors,
                           .ball = [](const SeenPoints& seen, const SeenFrom& from) {
                             return withLinks(seen, from.point);
                           }};
      });
  method.seesRoot = true;
  return method;
}

} // namespace

std::vector<Method> surfaceContractMethods() {
  return {oneStepLaplacianMethod(), implicitLaplacianMethod(), pathBasedMethod(),
          rotationalSymmetryMethod(), l1MedialMethod()};
}

} // namespace espalier
