#include "core/evaluate/match/authors_comparison.h"

#include "core/base/parallel.h"
#include "core/base/shown.h"
#include "core/evaluate/match/assignment.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/segment_matches.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace espalier {
namespace {

using Candidates = std::vector<std::vector<AssignmentProblem::Candidate>>;

/// The first segment of the reference is skipped: scans miss the foot of the trunk, so people
/// append it by hand as one long edge.
double authorsBoxDistance(const Skeleton& reference, const std::vector<Segment>& segments) {
  const auto child = std::find_if(segments.begin(), segments.end(), [](const Segment& segment) {
    return segment.parent == std::size_t{0};
  });
  const Segment& measured = child != segments.end() ? *child : segments.front();
  const std::size_t edges = measured.polyline.size() - 1;
  if (edges == 0 || measured.length == 0) return 2 * medianEdgeLength(reference);
  return 2 * measured.length / static_cast<double>(edges);
}

/// No two sets of points are nearer than their boxes' faces are apart: cheaper than measuring.
bool mayCostLessThan(double limit, const Segment& a, const Segment& b) {
  const double low = (a.box.min() - b.box.min()).cwiseAbs().maxCoeff();
  const double high = (a.box.max() - b.box.max()).cwiseAbs().maxCoeff();
  return std::max(low, high) < limit;
}

/// Candidates that are cheaper together than alone; counts in `near` all whose boxes are near.
std::vector<AssignmentProblem::Candidate> candidatesOf(const Segment& row,
                                                       const std::vector<Segment>& columns,
                                                       const BoxTree& boxes, double boxDistance,
                                                       std::size_t& near) {
  std::vector<AssignmentProblem::Candidate> result;
  boxes.within(row.box, boxDistance, [&](std::size_t column) {
    ++near;
    const Segment& other = columns[column];
    const double alone = row.length + other.length;
    if (alone > 0 && !mayCostLessThan(alone, row, other)) return;
    const double cost = vertexHausdorff(row.polyline, other.polyline);
    if (cost < alone || cost == 0) result.push_back({column, cost});
  });
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return a.column < b.column; });
  return result;
}

Candidates allCandidates(AuthorsComparison& comparison, const Progress& progress) {
  const std::vector<Segment>& rows = comparison.resultSegments;
  const BoxTree boxes = boxTree(comparison.referenceSegments);
  Candidates candidates(rows.size());
  std::vector<std::size_t> near(rows.size(), 0);
  parallelFor(
      static_cast<Eigen::Index>(rows.size()),
      [&](Eigen::Index i) {
        const auto row = static_cast<std::size_t>(i);
        candidates[row] = candidatesOf(rows[row], comparison.referenceSegments, boxes,
                                       comparison.boxDistance, near[row]);
      },
      progress, 16);
  comparison.candidates = std::accumulate(near.begin(), near.end(), std::size_t{0});
  return candidates;
}

/// Settles pairs at no distance that have no other such partner, as the authors do beforehand:
/// each keeps its one candidate, and no other row keeps its column.
void settleEqualPairs(Candidates& candidates, std::size_t columns) {
  std::vector<std::size_t> equalRows(columns, 0);
  std::vector<std::optional<std::size_t>> onlyEqual(candidates.size());
  for (std::size_t row = 0; row < candidates.size(); ++row) {
    std::size_t equals = 0;
    for (const auto& candidate : candidates[row])
      if (candidate.cost == 0) {
        ++equals;
        ++equalRows[candidate.column];
        onlyEqual[row] = candidate.column;
      }
    if (equals != 1) onlyEqual[row].reset();
  }
  std::vector<bool> isSettled(columns, false);
  for (std::optional<std::size_t>& column : onlyEqual) {
    if (column && equalRows[*column] != 1) column.reset();
    if (column) isSettled[*column] = true;
  }
  for (std::size_t row = 0; row < candidates.size(); ++row)
    std::erase_if(candidates[row], [&](const auto& candidate) {
      return onlyEqual[row] ? candidate.column != *onlyEqual[row]
                            : static_cast<bool>(isSettled[candidate.column]);
    });
}

std::vector<double> lengths(const std::vector<Segment>& segments) {
  std::vector<double> result;
  result.reserve(segments.size());
  for (const Segment& segment : segments)
    result.push_back(segment.length);
  return result;
}

void noteMatches(AuthorsComparison& comparison, const Candidates& candidates,
                 const Partners& partners) {
  const std::vector<bool> isConserved =
      conserved(comparison.resultSegments, comparison.referenceSegments, partners);
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (!partners[i]) continue;
    const auto found =
        std::find_if(candidates[i].begin(), candidates[i].end(),
                     [&](const auto& candidate) { return candidate.column == *partners[i]; });
    comparison.matches.push_back({i, *partners[i], found->cost, isConserved[i]});
  }
}

void noteIndices(AuthorsComparison& comparison) {
  double matchedResult = 0;
  double matchedReference = 0;
  std::size_t conservedMatches = 0;
  for (const AuthorsComparison::Match& match : comparison.matches) {
    matchedResult += comparison.resultSegments[match.result].length;
    matchedReference += comparison.referenceSegments[match.reference].length;
    if (match.isConserved) ++conservedMatches;
  }
  const double resultLength = totalLength(comparison.resultSegments);
  const double referenceLength = totalLength(comparison.referenceSegments);
  const auto matches = static_cast<double>(comparison.matches.size());
  const auto references = static_cast<double>(comparison.referenceSegments.size());
  comparison.mapping =
      2 * matches / (static_cast<double>(comparison.resultSegments.size()) + references);
  comparison.geometric = (matchedResult + matchedReference) / (resultLength + referenceLength);
  comparison.lengthPrecision = matchedResult / resultLength;
  comparison.lengthRecall = matchedReference / referenceLength;
  const auto kept = static_cast<double>(conservedMatches);
  comparison.structural = matches > 0 ? kept / matches : 0;
  comparison.structuralOfAll = kept / references;
}

} // namespace

AuthorsComparison authorsComparison(const Skeleton& result, const Skeleton& reference,
                                    const AuthorsOptions& options, const Progress& progress) {
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  AuthorsComparison comparison;
  comparison.resultSegments = unbranchedSegments(result);
  comparison.referenceSegments = unbranchedSegments(reference);
  comparison.boxDistance = options.boxDistance > 0
                               ? options.boxDistance
                               : authorsBoxDistance(reference, comparison.referenceSegments);

  AssignmentProblem problem;
  problem.rowAlone = lengths(comparison.resultSegments);
  problem.columnAlone = lengths(comparison.referenceSegments);
  problem.candidates =
      allCandidates(comparison, progress.part(0, 0.7, Shown::tr("Comparing segments")));
  settleEqualPairs(problem.candidates, problem.columnAlone.size());
  const Assignment assignment =
      leastCostAssignment(problem, progress.part(0.7, 1, Shown::tr("Matching segments")));

  comparison.cost = assignment.cost;
  noteMatches(comparison, problem.candidates, assignment.columnOfRow);
  noteIndices(comparison);
  return comparison;
}

} // namespace espalier
