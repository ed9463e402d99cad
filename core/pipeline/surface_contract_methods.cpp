#include "core/contract/implicit_laplacian.h"
#include "core/contract/one_step_laplacian.h"
#include "core/contract/path_based.h"
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
  return contractMethod<Options>(
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
}

} // namespace

std::vector<Method> surfaceContractMethods() {
  return {oneStepLaplacianMethod(), implicitLaplacianMethod(), pathBasedMethod()};
}

} // namespace espalier
