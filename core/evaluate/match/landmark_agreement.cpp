#include "core/evaluate/match/landmark_agreement.h"

#include "core/base/spatial_index.h"
#include "core/evaluate/match/assignment.h"
#include "core/evaluate/match/tolerance_curve.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

double share(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 1;
}

/// By place of the result: places of the reference within `distance`, lowest index first.
std::vector<std::vector<AssignmentProblem::Candidate>>
candidatesWithin(const std::vector<Eigen::Vector3d>& result,
                 const std::vector<Eigen::Vector3d>& reference, double distance) {
  const Eigen::Vector3d& origin = reference.front(); // floats would blur far frames
  Eigen::Matrix3Xf places(3, static_cast<Eigen::Index>(reference.size()));
  for (std::size_t i = 0; i < reference.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = (reference[i] - origin).cast<float>();
  const SpatialIndex index(places);
  std::vector<std::vector<AssignmentProblem::Candidate>> candidates(result.size());
  for (std::size_t row = 0; row < result.size(); ++row) {
    const Eigen::Vector3f place = (result[row] - origin).cast<float>();
    const double rounding = 1e-6 * (distance + place.cwiseAbs().maxCoeff()) + 1e-18;
    for (const Neighbor& found : index.within(place, static_cast<float>(distance + rounding))) {
      const auto column = static_cast<std::size_t>(found.index);
      const double apart = (reference[column] - result[row]).norm();
      if (apart <= distance) candidates[row].push_back({column, apart});
    }
    std::sort(candidates[row].begin(), candidates[row].end(),
              [](const auto& a, const auto& b) { return a.column < b.column; });
  }
  return candidates;
}

} // namespace

double LandmarkAgreement::precision() const {
  return share(matched, result);
}

double LandmarkAgreement::recall() const {
  return share(matched, reference);
}

double LandmarkAgreement::f() const {
  return harmonicMean(precision(), recall());
}

std::vector<std::optional<std::size_t>> landmarkPairs(const std::vector<Eigen::Vector3d>& result,
                                                      const std::vector<Eigen::Vector3d>& reference,
                                                      double distance) {
  if (result.empty() || reference.empty())
    return std::vector<std::optional<std::size_t>>(result.size());
  // A pair at the very distance must still be worth it: hence the hair more than half.
  const double alone = 0.5 * distance * (1 + 1e-9) + 1e-300;
  return leastCostAssignment({.candidates = candidatesWithin(result, reference, distance),
                              .rowAlone = std::vector<double>(result.size(), alone),
                              .columnAlone = std::vector<double>(reference.size(), alone)})
      .columnOfRow;
}

LandmarkAgreement landmarkAgreement(const std::vector<Eigen::Vector3d>& result,
                                    const std::vector<Eigen::Vector3d>& reference,
                                    double distance) {
  const auto pairs = landmarkPairs(result, reference, distance);
  const auto matched =
      std::ranges::count_if(pairs, [](const auto& column) { return column.has_value(); });
  return {.distance = distance,
          .matched = static_cast<std::size_t>(matched),
          .result = result.size(),
          .reference = reference.size()};
}

} // namespace espalier
