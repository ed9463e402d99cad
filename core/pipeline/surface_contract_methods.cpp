#include "core/contract/implicit_laplacian.h"
#include "core/contract/l1_medial.h"
#include "core/contract/one_step_laplacian.h"
#include "core/contract/path_based.h"
#include "core/contract/rotational_symmetry.h"
#include "core/pipeline/contract_parts.h"

#include <algorithm>

namespace espalier {
namespace {

struct OneStepOptions {
  int neighbors = 7;
};

Method oneStepLaplacianMethod() {
  OptionTable<OneStepOptions> table;
  Option neighbors = linksOption();
  neighbors.help = "How many of the nearest points each one moves to the mean of.";
  table.add(neighbors, &OneStepOptions::neighbors);
  return contractMethod<OneStepOptions>(
      {.name = "one_step_laplacian",
       .label = "One Laplacian step",
       .help = "Moves each point to the mean of its nearest ones: a slight smoothing.",
       .source = "Laplacian contraction of PlantScan3D"},
      table,
      [](const auto& points, const OneStepOptions& options, const auto&, const Progress& progress) {
        return contractedByOneLaplacianStep(points, options.neighbors, progress);
      });
}

Option countOption(const char* name, const char* label, double value, double minimum,
                   double maximum, const char* help) {
  return {.name = name,
          .label = label,
          .kind = OptionKind::count,
          .rule = fixedAt(value),
          .minimum = minimum,
          .maximum = maximum,
          .help = help};
}

Option ratioOption(const char* name, const char* label, double value, double minimum,
                   double maximum, const char* help) {
  Option option = countOption(name, label, value, minimum, maximum, help);
  option.kind = OptionKind::ratio;
  return option;
}

Method implicitLaplacianMethod() {
  using Options = ImplicitLaplacianOptions;
  const Options defaults;
  OptionTable<Options> table;
  table.add(countOption("neighbors", "Neighbors", defaults.neighbors, 3, 64,
                        "How many of the nearest points the ring about each one is chosen from."),
            &Options::neighbors);
  table.add(ratioOption("contraction", "Contraction", defaults.contraction, 0.01, 100,
                        "Factor on the weight of contraction in the first round."),
            &Options::contraction);
  table.add(ratioOption("growth", "Growth", defaults.growth, 1, 20,
                        "How much stronger each round contracts than the one before."),
            &Options::growth);
  table.add(countOption("rounds", "Rounds", defaults.rounds, 0, 20,
                        "How often the equations are solved; more of them shorten twigs."),
            &Options::rounds);
  return contractMethod<Options>(
      {.name = "implicit_laplacian",
       .label = "Implicit Laplacian",
       .help = "Solves for places where the surface has shrunk to lines; bridges holes, is slow.",
       .source = "J. Cao et al., Point cloud skeletons via Laplacian based contraction, SMI 2010"},
      table, [](const auto& points, const Options& options, const auto&, const Progress& progress) {
        return contractedByImplicitLaplacian(points, options, progress);
      });
}

Option reachOption(const char* name, const char* label, double count, const char* help) {
  return {.name = name,
          .label = label,
          .kind = OptionKind::length,
          .rule = spacings(count),
          .minimum = 0.5,
          .maximum = 200,
          .help = help};
}

Method l1MedialMethod() {
  using Options = L1MedialOptions;
  const Options defaults;
  OptionTable<Options> table;
  table.add(ratioOption("sample_share", "Samples", 0.2, 0.001, 1,
                        "Share of the points that become samples; the others move with these."),
            &Options::sampleShare);
  table.add(reachOption("first_radius", "First radius", 4,
                        "Neighborhoods of the first stage; each stage adds half of it."),
            &Options::firstRadius);
  table.add(reachOption("last_radius", "Last radius", 12,
                        "No stage looks farther than this. More reaches the middle of thicker wood "
                        "and merges more twigs."),
            &Options::lastRadius);
  table.add(countOption("stage_rounds", "Rounds per stage", defaults.roundsPerStage, 1, 200,
                        "How often samples move in a stage, if they do not rest before."),
            &Options::roundsPerStage);
  table.add(ratioOption("repulsion", "Repulsion", defaults.repulsion, 0, 0.5,
                        "How strongly samples push each other apart along the lines they form."),
            &Options::repulsion);
  table.add(ratioOption("least_direction", "Least direction", defaults.leastDirection, 0.5, 1,
                        "Share of their spread that must lie along a line before samples become a "
                        "branch and rest."),
            &Options::leastDirection);
  return contractMethod<Options>(
      {.name = "l1_medial",
       .label = "L1 medial",
       .help = "Moves samples to medians of the points about them, while they push each other "
               "apart; bears holes, is slow.",
       .source = "H. Huang et al., L1-medial skeleton of point cloud, ACM Trans. Graph. 32(4), "
                 "2013"},
      table, [](const auto& points, const Options& options, const auto&, const Progress& progress) {
        Options inOrder = options;
        inOrder.lastRadius = std::max(inOrder.firstRadius, inOrder.lastRadius);
        return contractedToL1Medial(points, inOrder, progress);
      });
}

Method rotationalSymmetryMethod() {
  using Options = RotationalSymmetryOptions;
  const Options defaults;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors);
  table.add(countOption("normal_neighbors", "Points of normals", defaults.normalNeighbors, 3, 64,
                        "How many of the nearest points the normal of each one is found from."),
            &Options::normalNeighbors);
  table.add(reachOption("width", "Width", 2, "Half of the thickness of a section, along the wood."),
            &Options::width);
  table.add(reachOption("reach", "Reach", 8,
                        "How far a section goes across the wood; it need not reach around it."),
            &Options::reach);
  table.add(countOption("axis_rounds", "Rounds", defaults.rounds, 1, 20,
                        "How often sections and axes are found in turn."),
            &Options::rounds);
  table.add(countOption("smoothing", "Smoothing", defaults.smoothing, 0, 50,
                        "How often places that normals do not determine follow their neighbors."),
            &Options::smoothing);
  return contractMethod<Options>(
      {.name = "rotational_symmetry",
       .label = "Rotational symmetry axes",
       .help = "Moves each point to where the normals of its section meet: the middle of round "
               "wood, of which only a part is seen.",
       .source = "A. Tagliasacchi, H. Zhang, D. Cohen-Or, ACM Trans. Graph. 28(3), 2009 (ROSA)"},
      table, [](const auto& points, const Options& options, const auto&, const Progress& progress) {
        return contractedToSymmetryAxes(points, options, progress);
      });
}

/// The root of the plant among the points that were kept.
Eigen::Index keptRoot(const PipelineState& state) {
  const std::vector<Eigen::Index> kept = keptPoints(state);
  return std::lower_bound(kept.begin(), kept.end(), state.root) - kept.begin();
}

Method pathBasedMethod() {
  using Options = PathBasedOptions;
  const Options defaults;
  OptionTable<Options> table;
  table.add(linksOption(), &Options::neighbors);
  table.add(
      countOption("rounds", "Rounds", defaults.rounds, 0, 20, "How often paths are smoothed."),
      &Options::rounds);
  Method method = contractMethod<Options>(
      {.name = "path_based",
       .label = "Along paths",
       .help = "Straightens the paths from all points to the root, twigs after the wood that "
               "carries them.",
       .source = "Y. Livny et al., ACM Trans. Graph. 29(6), 2010"},
      table,
      [](const auto& points, const Options& options, const PipelineState& state,
         const Progress& progress) {
        return contractedAlongPaths(points, keptRoot(state), options, progress);
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
