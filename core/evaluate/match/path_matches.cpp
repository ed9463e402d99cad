#include "core/evaluate/match/path_matches.h"

#include "core/base/parallel.h"
#include "core/evaluate/match/segment_matches.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace espalier {
namespace {

using SegmentPath = std::vector<std::size_t>;

/// The segments of one skeleton, and which of them are still free.
struct PathSide {
  const std::vector<Segment>* segments;
  std::vector<SegmentPath> children; // by segment
  std::vector<bool> isTaken;         // by segment
};

PathSide sideOf(const std::vector<Segment>& segments) {
  PathSide side{.segments = &segments,
                .children = std::vector<SegmentPath>(segments.size()),
                .isTaken = std::vector<bool>(segments.size(), false)};
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i].parent) side.children[*segments[i].parent].push_back(i);
  return side;
}

/// Distances from the vertices of one polyline to those of another; squared [L^2].
std::vector<double> squaredToEach(const std::vector<Eigen::Vector3d>& from,
                                  const std::vector<Eigen::Vector3d>& to) {
  std::vector<double> nearest(from.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < from.size(); ++i)
    for (const Eigen::Vector3d& other : to)
      nearest[i] = std::min(nearest[i], (from[i] - other).squaredNorm());
  return nearest;
}

/// A path through a segment, with what its Hausdorff distance to `target` is made of.
struct Reach {
  SegmentPath path;           // without the segment it starts at
  double farthest = 0;        // from its vertices to the target's; squared
  std::vector<double> toPath; // from each of the target's vertices; squared
};

Reach withSegment(Reach reach, const PathSide& side, std::size_t segment, const Segment& target) {
  const std::vector<Eigen::Vector3d>& polyline = (*side.segments)[segment].polyline;
  reach.path.push_back(segment);
  reach.farthest =
      std::max(reach.farthest, std::ranges::max(squaredToEach(polyline, target.polyline)));
  const std::vector<double> near = squaredToEach(target.polyline, polyline);
  for (std::size_t i = 0; i < near.size(); ++i)
    reach.toPath[i] = std::min(reach.toPath[i], near[i]);
  return reach;
}

/// All paths upward along free segments that stay within sqrt(limit) of the target.
std::vector<Reach> reachesUp(const PathSide& side, std::size_t segment, const Segment& target,
                             double limit) {
  std::vector<Reach> found = {
      {{}, 0, squaredToEach(target.polyline, (*side.segments)[segment].polyline)}};
  for (std::size_t next = 0; next < found.size(); ++next) {
    const std::size_t from = found[next].path.empty() ? segment : found[next].path.back();
    for (const std::size_t child : side.children[from]) {
      if (side.isTaken[child]) continue;
      Reach longer = withSegment(found[next], side, child, target);
      if (longer.farthest < limit) found.push_back(std::move(longer));
    }
  }
  return found;
}

/// The same downward, where there is one path only.
std::vector<Reach> reachesDown(const PathSide& side, std::size_t segment, const Segment& target,
                               double limit) {
  std::vector<Reach> found = {
      {{}, 0, squaredToEach(target.polyline, (*side.segments)[segment].polyline)}};
  for (auto below = (*side.segments)[segment].parent; below && !side.isTaken[*below];
       below = (*side.segments)[*below].parent) {
    Reach longer = withSegment(found.back(), side, *below, target);
    if (longer.farthest >= limit) break;
    found.push_back(std::move(longer));
  }
  return found;
}

struct Extension {
  SegmentPath path; // from the root side; empty: nothing brings the two nearer
  double cost{};    // [L]
};

/// The path of free segments through `segment` that is nearest to `target`.
Extension bestThrough(const PathSide& side, std::size_t segment, const Segment& target,
                      double cost) {
  const double limit = cost * cost;
  const double own =
      std::ranges::max(squaredToEach((*side.segments)[segment].polyline, target.polyline));
  const std::vector<Reach> ups = reachesUp(side, segment, target, limit);
  const std::vector<Reach> downs = reachesDown(side, segment, target, limit);
  Extension best{.path = {}, .cost = cost};
  for (const Reach& down : downs)
    for (const Reach& up : ups) {
      double squared = std::max({own, down.farthest, up.farthest});
      for (std::size_t i = 0; i < up.toPath.size() && squared < best.cost * best.cost; ++i)
        squared = std::max(squared, std::min(up.toPath[i], down.toPath[i]));
      if (std::sqrt(squared) >= best.cost) continue;
      best = {.path = {down.path.rbegin(), down.path.rend()}, .cost = std::sqrt(squared)};
      best.path.push_back(segment);
      best.path.insert(best.path.end(), up.path.begin(), up.path.end());
    }
  return best;
}

struct Choice {
  Extension extension;
  bool isOfResult = true; // which side becomes a path
};

Choice bestFor(const PathSide& result, const PathSide& reference,
               const AuthorsComparison::Match& match) {
  Choice choice{
      bestThrough(result, match.result, (*reference.segments)[match.reference], match.cost), true};
  Extension other = bestThrough(reference, match.reference, (*result.segments)[match.result],
                                choice.extension.cost);
  if (!other.path.empty()) choice = {std::move(other), false};
  return choice;
}

/// Extends matches, the one that gains most first, as long as what they take in is free.
void takeBestFirst(PathMatches& paths, std::vector<Choice>& choices,
                   const AuthorsComparison& comparison, PathSide& result, PathSide& reference) {
  using Gain = std::pair<double, std::size_t>; // by how much the match at this index gets nearer
  const auto less = [](const Gain& a, const Gain& b) { // the lower index of equal gains first
    return a.first < b.first || (a.first == b.first && a.second > b.second);
  };
  std::priority_queue<Gain, std::vector<Gain>, decltype(less)> open(less);
  const auto offer = [&](std::size_t k) {
    const Extension& extension = choices[k].extension;
    if (!extension.path.empty()) open.emplace(comparison.matches[k].cost - extension.cost, k);
  };
  for (std::size_t k = 0; k < choices.size(); ++k)
    offer(k);
  while (!open.empty()) {
    const std::size_t k = open.top().second;
    open.pop();
    const AuthorsComparison::Match& match = comparison.matches[k];
    const auto& [extension, isOfResult] = choices[k];
    PathSide& side = isOfResult ? result : reference;
    const std::size_t own = isOfResult ? match.result : match.reference;
    const bool isFree = std::ranges::all_of(extension.path, [&](std::size_t segment) {
      return segment == own || !side.isTaken[segment];
    });
    if (!isFree) { // another match took a part of it meanwhile
      choices[k] = bestFor(result, reference, match);
      offer(k);
      continue;
    }
    for (const std::size_t segment : extension.path)
      side.isTaken[segment] = true;
    (isOfResult ? paths.matches[k].result : paths.matches[k].reference) = extension.path;
    paths.matches[k].cost = extension.cost;
  }
}

void summarize(PathMatches& paths, const AuthorsComparison& comparison, const PathSide& result,
               const PathSide& reference) {
  const auto covered = [](const PathSide& side) {
    double length = 0;
    for (std::size_t i = 0; i < side.isTaken.size(); ++i)
      if (side.isTaken[i]) length += (*side.segments)[i].length;
    return length;
  };
  const double resultLength = totalLength(comparison.resultSegments);
  const double referenceLength = totalLength(comparison.referenceSegments);
  const double coveredResult = covered(result);
  const double coveredReference = covered(reference);
  paths.cost = resultLength - coveredResult + referenceLength - coveredReference;
  for (const PathMatch& match : paths.matches) {
    paths.cost += match.cost;
    if (match.result.size() + match.reference.size() > 2) ++paths.extended;
  }
  paths.geometric = (coveredResult + coveredReference) / (resultLength + referenceLength);
  paths.lengthPrecision = coveredResult / resultLength;
  paths.lengthRecall = coveredReference / referenceLength;
}

} // namespace

PathMatches pathMatches(const AuthorsComparison& comparison, const Progress& progress) {
  PathSide result = sideOf(comparison.resultSegments);
  PathSide reference = sideOf(comparison.referenceSegments);
  PathMatches paths;
  for (const AuthorsComparison::Match& match : comparison.matches) {
    result.isTaken[match.result] = true;
    reference.isTaken[match.reference] = true;
    paths.matches.push_back({{match.result}, {match.reference}, match.cost});
  }
  std::vector<Choice> choices(comparison.matches.size());
  parallelFor(
      static_cast<Eigen::Index>(choices.size()),
      [&](Eigen::Index i) {
        const auto k = static_cast<std::size_t>(i);
        choices[k] = bestFor(result, reference, comparison.matches[k]);
      },
      progress, 16);

  takeBestFirst(paths, choices, comparison, result, reference);
  summarize(paths, comparison, result, reference);
  return paths;
}

} // namespace espalier
