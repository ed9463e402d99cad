#include "core/pipeline/method_parts.h"
#include "core/pipeline/methods.h"
#include "core/reconstruct/geodesic_bins.h"

namespace espalier {
namespace {

Method geodesicBinsMethod() {
  using Options = GeodesicBinOptions;
  OptionTable<Options> table;
  table.add(linksOverGapsOption(), &Options::neighbors, &PointLinks::count);
  table.add(
      lengthOption(
          "bin_width", Shown::tr("Bin width"), 1, 100,
          Shown::tr(
              "Distance between nodes along the plant. Less finds more twigs, and more spurs.")),
      &Options::binWidth);
  table.add(widestGapOption(), &Options::widestGap);
  table.add(
      ratioOption(
          "turn_cost", Shown::tr("Cost of turns"), 0, 100,
          Shown::tr("How much more a link costs across the wood than along it, when twigs touch; 0 "
                    "takes the shortest path.")),
      &Options::turnCost);
  table.add(ratioOption("ring", Shown::tr("Ring"), 0, 10,
                        Shown::tr("Two sides of wood that lie nearer to each other than this, in "
                                  "bin widths, and part below and meet above, are one; 0 keeps "
                                  "both.")),
            &Options::ring);
  table.add(linkKindOption(), &Options::neighbors, &PointLinks::kind);
  return {.name = "geodesic_bins",
          .label = Shown::tr("Geodesic bins"),
          .help = Shown::tr("One node per connected part of each bin of the distance to the root."),
          .inManual = Shown::tr("cuts the plant into pieces of equal distance to the root"),
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
