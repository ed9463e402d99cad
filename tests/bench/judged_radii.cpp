#include "tests/bench/judged_radii.h"

#include "core/base/quantile.h"
#include "core/base/spatial_index.h"
#include "core/radius/arc_coverage.h"
#include "core/skeleton/edge_index.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace espalier {
namespace {

void print(const RadiusErrors& errors) {
  std::printf("%6zu nodes, median error %.3f, signed %.3f\n", errors.count, errors.median,
              errors.signedMedian);
}

} // namespace

std::vector<std::optional<TrueWood>> trueWood(const Skeleton& result, const Skeleton& truth,
                                              double spacing) {
  const EdgeIndex edges(truth);
  std::vector<std::optional<TrueWood>> wood(result.idEnd());
  for (const NodeId id : result.ids()) {
    const auto place = edges.nearest(result[id].position);
    if (!place) continue;
    const Node& upper = truth[place->node];
    double radius = upper.radius;
    if (upper.parent && upper.edge == EdgeType::successor) {
      const Node& lower = truth[*upper.parent];
      const double length = (upper.position - lower.position).norm();
      const double share = length > 0 ? (upper.position - place->position).norm() / length : 0;
      radius = (1 - share) * upper.radius + share * lower.radius;
    }
    if (radius > 0 && place->distance <= radius + spacing)
      wood[indexOf(id)] = TrueWood{place->node, radius};
  }
  return wood;
}

std::vector<JudgedRadius> judgedRadii(const Skeleton& result, const Skeleton& truth,
                                      const PointCloud& scan, double spacing) {
  const SpatialIndex points(scan.positions());
  const std::vector<double> seen =
      arcCoverages(truth, {scan.positions(), scan.origin(), points, spacing});
  const auto wood = trueWood(result, truth, spacing);
  std::vector<JudgedRadius> judged;
  for (const NodeId id : result.ids())
    if (const auto& [node, radius] = wood[indexOf(id)].value_or(TrueWood{}); radius > 0)
      judged.push_back({radius / spacing, seen[indexOf(node)], result[id].radius / radius - 1});
  return judged;
}

RadiusErrors errorsOf(const std::vector<JudgedRadius>& judged, const WoodRange& wood) {
  std::vector<double> errors;
  for (const JudgedRadius& each : judged)
    if (each.thickness >= wood.thinnest && each.thickness < wood.thickest &&
        each.seen >= wood.leastSeen && each.seen < wood.mostSeen)
      errors.push_back(each.error);
  RadiusErrors result{.count = errors.size(), .signedMedian = quantile(errors, 0.5).value_or(0)};
  for (double& error : errors)
    error = std::abs(error);
  result.median = quantile(std::move(errors), 0.5).value_or(0);
  return result;
}

void printRadii(const std::vector<JudgedRadius>& judged) {
  constexpr double limits[] = {0, 0.5, 1, 2, 4, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i + 1 < std::size(limits); ++i) {
    std::printf("  radii from %.1f to %.1f spacings: ", limits[i], limits[i + 1]);
    print(errorsOf(judged, {.thinnest = limits[i], .thickest = limits[i + 1]}));
  }
  constexpr double quarters[] = {0, 0.25, 0.5, 0.75, 2};
  for (std::size_t i = 0; i + 1 < std::size(quarters); ++i) {
    std::printf("  seen from %3.0f to %3.0f %% around: ", 100 * quarters[i],
                100 * std::min(1.0, quarters[i + 1]));
    print(errorsOf(judged, {.thinnest = 1, .leastSeen = quarters[i], .mostSeen = quarters[i + 1]}));
  }
}

} // namespace espalier
