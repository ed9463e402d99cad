#include "core/evaluate/match/architecture_agreement.h"

#include "core/base/parallel.h"
#include "core/evaluate/match/assignment.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/even_samples.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edge_index.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <vector>

namespace espalier {
namespace {

/// By id: which axis a node is on.
std::vector<std::size_t> axisOfEach(const Skeleton& skeleton) {
  std::vector<std::size_t> axisOf(skeleton.idEnd(), 0);
  const std::vector<Axis> all = axes(skeleton);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const NodeId id : all[i])
      axisOf[indexOf(id)] = i;
  return axisOf;
}

/// A place of the reference and the node of the result at whose edge it is found.
struct Found {
  NodeId reference;
  NodeId result;
};

std::vector<Found> foundWithin(const Skeleton& result, const std::vector<EvenSample>& samples,
                               double distance, const Progress& progress) {
  const EdgeIndex index(result);
  std::vector<std::optional<NodeId>> nodes(samples.size());
  parallelFor(
      static_cast<Eigen::Index>(samples.size()),
      [&](Eigen::Index i) {
        const auto k = static_cast<std::size_t>(i);
        const auto place = index.nearest(samples[k].position);
        if (place->distance <= distance) nodes[k] = place->node;
      },
      progress);
  std::vector<Found> found;
  for (std::size_t k = 0; k < samples.size(); ++k)
    if (nodes[k]) found.push_back({samples[k].node, *nodes[k]});
  return found;
}

/// How many of the places lie on axes that stand for each other.
std::size_t onSameAxis(const std::vector<Found>& found, const std::vector<std::size_t>& resultAxis,
                       const std::vector<std::size_t>& referenceAxis) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> shared; // reference, result
  std::size_t rows = 0;
  std::size_t columns = 0;
  for (const Found& place : found) {
    const std::size_t row = referenceAxis[indexOf(place.reference)];
    const std::size_t column = resultAxis[indexOf(place.result)];
    ++shared[{row, column}];
    rows = std::max(rows, row + 1);
    columns = std::max(columns, column + 1);
  }
  AssignmentProblem problem{.candidates =
                                std::vector<std::vector<AssignmentProblem::Candidate>>(rows),
                            .rowAlone = std::vector<double>(rows, 0),
                            .columnAlone = std::vector<double>(columns, 0)};
  for (const auto& [axes, places] : shared)
    problem.candidates[axes.first].push_back({axes.second, -static_cast<double>(places)});
  const Assignment assignment = leastCostAssignment(problem);
  std::size_t same = 0;
  for (std::size_t row = 0; row < rows; ++row)
    if (const auto column = assignment.columnOfRow[row]) same += shared[{row, *column}];
  return same;
}

void compareOrders(ArchitectureAgreement& agreed, const std::vector<Found>& found,
                   const std::vector<int>& resultOrder, const std::vector<int>& referenceOrder,
                   double length) {
  const int most = *std::ranges::max_element(referenceOrder);
  agreed.byOrder.resize(static_cast<std::size_t>(most) + 1);
  std::vector<std::size_t> all(agreed.byOrder.size(), 0);
  std::vector<std::size_t> same(agreed.byOrder.size(), 0);
  std::size_t sameOfAll = 0;
  for (const Found& place : found) {
    const int order = referenceOrder[indexOf(place.reference)];
    const bool isSame = resultOrder[indexOf(place.result)] == order;
    ++all[static_cast<std::size_t>(order)];
    if (!isSame) continue;
    ++same[static_cast<std::size_t>(order)];
    ++sameOfAll;
  }
  for (std::size_t order = 0; order < all.size(); ++order) {
    agreed.byOrder[order].length = length * static_cast<double>(all[order]);
    if (all[order] > 0)
      agreed.byOrder[order].same =
          static_cast<double>(same[order]) / static_cast<double>(all[order]);
  }
  if (!found.empty())
    agreed.sameOrder = static_cast<double>(sameOfAll) / static_cast<double>(found.size());
}

} // namespace

ArchitectureAgreement architectureAgreement(const Skeleton& result, const Skeleton& reference,
                                            const AuthorsComparison& matches, double distance,
                                            double step, const Progress& progress) {
  assert(distance > 0 && step > 0);
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  const std::vector<EvenSample> samples = evenSamples(reference, step);
  const auto all = static_cast<double>(samples.size());
  const std::vector<Found> found = foundWithin(result, samples, distance, progress);
  ArchitectureAgreement agreed{.distance = distance,
                               .compared = static_cast<double>(found.size()) / all};
  compareOrders(agreed, found, orders(result), orders(reference), totalLength(reference) / all);
  if (!found.empty())
    agreed.sameAxis =
        static_cast<double>(onSameAxis(found, axisOfEach(result), axisOfEach(reference))) /
        static_cast<double>(found.size());
  agreed.types = typeAgreement(matches, result, reference);
  return agreed;
}

} // namespace espalier
