#include "core/cloud/far_points.h"
#include "core/cloud/isolated_points.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/methods.h"

namespace espalier {
namespace {

Method isolatedPointsMethod() {
  using Options = IsolatedPointOptions;
  OptionTable<Options> table;
  table.add(countOption("neighbors", Shown::tr("Neighbors"), 1, 64,
                        Shown::tr("How many of the nearest points are looked at.")),
            &Options::neighbors);
  table.add(
      lengthOption(
          "distance", Shown::tr("Distance"), 0.5, 100,
          Shown::tr(
              "A point is left out if its neighbors are farther away than this in the mean.")),
      &Options::distance);
  return {.name = "isolated_points",
          .label = Shown::tr("Leave out isolated points"),
          .help = Shown::tr(
              "Leaves out points that stand alone, as dust and split laser beams do, and the few "
              "that lie far from the plant."),
          .source = "as in statistical outlier removal, with a distance in point spacings",
          .options = table.descriptions(),
          .seesRoot = false,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            for (const Eigen::Index far : farPoints(*state.cloud, state.isLeftOut))
              state.isLeftOut[static_cast<std::size_t>(far)] = true;
            const std::vector<Eigen::Index> kept = keptPoints(state);
            const std::vector<bool> isIsolated =
                isolatedPoints(*scannedIndex(state, kept, progress), table.with(values), progress);
            for (std::size_t i = 0; i < kept.size(); ++i)
              if (isIsolated[i]) state.isLeftOut[static_cast<std::size_t>(kept[i])] = true;
          }};
}

} // namespace

std::vector<Method> cleanMethods() {
  return {isolatedPointsMethod(), noMethod(Shown::tr("Keeps all points."))};
}

} // namespace espalier
