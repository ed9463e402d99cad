#include "core/pipeline/skeleton_methods.h"

#include "core/pipeline/colonization_methods.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/path_methods.h"
#include "core/reconstruct/geodesic_bins.h"

namespace espalier {
namespace {

Method geodesicBinsMethod() {
  using Options = GeodesicBinOptions;
  OptionTable<Options> table;
  table.add(linksPerPoint(12), &Options::neighbors);
  table.add(
      {.name = "bin_width",
       .label = "Bin width",
       .kind = OptionKind::length,
       .rule = spacings(6),
       .minimum = 1,
       .maximum = 100,
       .help = "Distance between nodes along the plant. Less finds more twigs, and more spurs."},
      &Options::binWidth);
  table.add(widestGap(), &Options::widestGap);
  table.add({.name = "turn_cost",
             .label = "Cost of turns",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0),
             .minimum = 0,
             .maximum = 100,
             .help =
                 "How much more a link costs across the wood than along it, when twigs touch; 0 "
                 "takes the shortest path."},
            &Options::turnCost);
  return {.name = "geodesic_bins",
          .label = "Geodesic bins",
          .help = "One node per connected part of each bin of the distance to the root.",
          .source = "H. Xu, N. Gossett, B. Chen, ACM Trans. Graph. 26(4), 2007",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonByGeodesicBins(points, root, table.with(values), progress);
            });
          }};
}

} // namespace

std::vector<Method> skeletonMethods() {
  return {geodesicBinsMethod(),      graphColonizationMethod(), pointTrackingMethod(),
          spaceColonizationMethod(), shortestPathMethod(),      branchStructureMethod()};
}

} // namespace espalier
