#include "core/skeleton/still_so.h"

#include "core/skeleton/blades_along.h"

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

/// The rest of a bare twig, if that is half of it; none too if a finding names some of the rest.
std::optional<Finding> restOf(const Finding& twig, const std::vector<Finding>& now,
                              const PointsNow& points) {
  const PointDistances& distances = points.distances;
  const auto toSurface = [&](Eigen::Index point) {
    return distances.toSurface()[static_cast<std::size_t>(point)];
  };
  Finding rest = twig;
  std::erase_if(rest.points,
                [&](Eigen::Index point) { return !(toSurface(point) > points.reach); });
  rest.points =
      pointsOffBlades(points.skeleton, rest.points, distances, points.reach, points.spacing);
  if (2 * rest.points.size() < twig.points.size()) return std::nullopt;
  const auto names = [](const Finding& finding, Eigen::Index point) {
    return std::ranges::binary_search(finding.points, point);
  };
  for (const Finding& other : now)
    if (std::ranges::any_of(rest.points, [&](Eigen::Index point) { return names(other, point); }))
      return std::nullopt;
  const Eigen::Index nearest = *std::ranges::min_element(rest.points, {}, toSurface);
  rest.node = distances.nearest()[static_cast<std::size_t>(nearest)];
  rest.amount = static_cast<double>(rest.points.size());
  place(rest, *distances.cloud());
  return rest;
}

} // namespace

std::vector<Finding> stillSo(const std::vector<Finding>& reported, const std::vector<Finding>& now,
                             const std::vector<Finding>& weaker, const PointsNow* points) {
  std::vector<Finding> still;
  for (const Finding& before : reported) {
    const auto isIt = [&](const Finding& finding) { return isSame(finding, before); };
    if (std::ranges::any_of(now, isIt)) continue;
    if (before.kind == Finding::Kind::unexplainedPoints) {
      if (points == nullptr || before.points.empty()) continue;
      std::optional<Finding> rest = restOf(before, now, *points);
      // Of two that name the same points now, one is enough.
      if (rest && std::ranges::none_of(still, [&](const Finding& other) {
            return !other.points.empty() && isSame(other, *rest);
          }))
        still.push_back(std::move(*rest));
      continue;
    }
    const auto found = std::ranges::find_if(weaker, isIt);
    if (found != weaker.end() && 2 * found->amount >= before.amount) still.push_back(*found);
  }
  return still;
}

} // namespace espalier
