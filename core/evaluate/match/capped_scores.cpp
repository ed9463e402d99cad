#include "core/evaluate/match/capped_scores.h"

#include "core/base/parallel.h"
#include "core/base/shown_message.h"
#include "core/evaluate/match/assignment.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/polyline_distance.h"
#include "core/evaluate/match/segment_matches.h"
#include "core/evaluate/match/tolerance_curve.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace espalier {
namespace {

using Candidates = std::vector<std::vector<AssignmentProblem::Candidate>>;

struct CappedSide {
  std::vector<Segment> segments;
  std::vector<Polyline> places; // by segment, at even steps
};

/// @param step  [L]; a larger one is taken where more places would be needed than any plant has:
/// one
///              node of a damaged file may lie a million times farther than all others
CappedSide sideOf(const Skeleton& skeleton, double step) {
  constexpr double mostPlaces = 2e6;
  step = std::max(step, totalLength(skeleton) / mostPlaces);
  CappedSide side{.segments = unbranchedSegments(skeleton), .places = {}};
  side.places.reserve(side.segments.size());
  for (const Segment& segment : side.segments)
    side.places.push_back(evenPlaces(segment.polyline, step));
  return side;
}

/// By segment of the result: those of the reference that are at most `farthest` away and nearer
/// than what leaving them alone costs.
Candidates candidatesWithin(const CappedSide& result, const CappedSide& reference, double farthest,
                            const Progress& progress) {
  const BoxTree boxes = boxTree(reference.segments);
  Candidates candidates(result.segments.size());
  parallelFor(
      static_cast<Eigen::Index>(candidates.size()),
      [&](Eigen::Index i) {
        const auto row = static_cast<std::size_t>(i);
        const Polyline& polyline = result.segments[row].polyline;
        boxes.within(result.segments[row].box, farthest, [&](std::size_t column) {
          const Segment& other = reference.segments[column];
          const double limit = std::min(farthest, 2 * other.length);
          const double there = farthestOf(result.places[row], other.polyline, limit);
          if (there > limit) return;
          const double cost =
              std::max(there, farthestOf(reference.places[column], polyline, limit));
          if (cost <= limit) candidates[row].push_back({column, cost});
        });
        std::ranges::sort(candidates[row], {}, &AssignmentProblem::Candidate::column);
      },
      progress, 16);
  return candidates;
}

CappedScore scoreOf(const CappedSide& result, const CappedSide& reference, const Partners& partners,
                    double distance) {
  CappedScore score{.distance = distance, .partners = partners, .isConserved = {}};
  score.isConserved = conserved(result.segments, reference.segments, partners);
  double length = 0;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (!partners[i]) continue;
    ++score.matched;
    length += result.segments[i].length + reference.segments[*partners[i]].length;
  }
  const auto kept = static_cast<double>(std::ranges::count(score.isConserved, true));
  const auto matched = static_cast<double>(score.matched);
  const auto references = static_cast<double>(reference.segments.size());
  score.mapping = 2 * matched / (static_cast<double>(result.segments.size()) + references);
  const double whole = totalLength(result.segments) + totalLength(reference.segments);
  score.geometric = std::min(1.0, length / whole); // the sums round differently
  score.structural = matched > 0 ? kept / matched : 0;
  score.structuralOfAll = kept / references;
  return score;
}

std::vector<double> checked(const std::vector<double>& distances, const Skeleton& reference) {
  if (distances.empty()) return defaultTolerances(reference);
  for (const double distance : distances)
    if (!(distance > 0 && std::isfinite(distance)))
      throw ShownError(
          {Shown::tr("distance %1: expected a length above 0"), {std::to_string(distance)}});
  return distances;
}

} // namespace

std::vector<CappedScore> cappedScores(const Skeleton& result, const Skeleton& reference,
                                      const CappedOptions& options, const Progress& progress) {
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  const std::vector<double> distances = checked(options.distances, reference);
  const double step = options.step > 0 ? options.step : std::ranges::min(distances);
  const CappedSide found = sideOf(result, step);
  const CappedSide truth = sideOf(reference, step);

  // A hair more than leaving it alone costs: segments without a length are matched, too.
  const double hair =
      1e-9 * totalLength(truth.segments) / static_cast<double>(truth.segments.size());
  AssignmentProblem problem{.candidates = {},
                            .rowAlone = std::vector<double>(found.segments.size(), 0),
                            .columnAlone = {}};
  for (const Segment& segment : truth.segments)
    problem.columnAlone.push_back(2 * segment.length + hair);
  const Candidates all =
      candidatesWithin(found, truth, std::ranges::max(distances), progress.part(0, 0.6));

  std::vector<CappedScore> scores;
  const auto parts = static_cast<double>(distances.size());
  for (const double distance : distances) {
    problem.candidates = all;
    for (auto& row : problem.candidates)
      std::erase_if(row, [&](const auto& candidate) { return candidate.cost > distance; });
    const auto part = static_cast<double>(scores.size());
    const Assignment assignment = leastCostAssignment(
        problem, progress.part(0.6 + 0.4 * part / parts, 0.6 + 0.4 * (part + 1) / parts));
    scores.push_back(scoreOf(found, truth, assignment.columnOfRow, distance));
  }
  return scores;
}

} // namespace espalier
