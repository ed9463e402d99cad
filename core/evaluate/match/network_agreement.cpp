#include "core/evaluate/match/network_agreement.h"

#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/landmark_tree.h"
#include "core/evaluate/match/tolerance_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <utility>

namespace espalier {
namespace {

/// Mean over the length of `from` of how wrong its places are.
double wrongShare(const Skeleton& from, const Skeleton& to, const NetworkOptions& options,
                  const Progress& progress) {
  const std::vector<double> distances =
      distancesTo(EdgeIndex(to), evenSamples(from, options.step), progress);
  double right = 0;
  for (const double distance : distances)
    right += std::exp(-0.5 * std::pow(distance / options.deviation, 2));
  return 1 - right / static_cast<double>(distances.size());
}

/// Pairs of landmarks, the lower number first.
using Connections = std::set<std::pair<std::size_t, std::size_t>>;

/// @param names of the landmarks, by which both plants know them; none: the other lacks it
Connections connectionsOf(const std::vector<Landmark>& landmarks, const Partners& names) {
  Connections found;
  const std::vector<PathBelow> paths = pathsBelow(landmarks, names);
  for (std::size_t i = 0; i < landmarks.size(); ++i)
    if (const auto& below = paths[i].landmark; names[i] && below)
      found.insert(std::minmax({*names[i], *names[*below]}));
  return found;
}

double shareLacking(const Connections& of, const Connections& in) {
  if (of.empty()) return 0;
  const auto lacking =
      std::ranges::count_if(of, [&](const auto& each) { return !in.contains(each); });
  return static_cast<double>(lacking) / static_cast<double>(of.size());
}

} // namespace

NetworkAgreement networkAgreement(const Skeleton& result, const Skeleton& reference,
                                  const NetworkOptions& options, const Progress& progress) {
  assert(options.deviation > 0 && options.distance > 0 && options.step > 0);
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  const std::vector<Landmark> found = landmarksOf(result);
  const std::vector<Landmark> truth = landmarksOf(reference);
  const Partners partners = partnersOf(found, truth, options.distance);
  Partners own = inverse(partners, truth.size()); // known by their places in the reference
  for (std::size_t i = 0; i < own.size(); ++i)
    if (own[i]) own[i] = i;
  const Connections there = connectionsOf(found, partners);
  const Connections here = connectionsOf(truth, own);
  return {.deviation = options.deviation,
          .missedLength = wrongShare(reference, result, options, progress.part(0, 0.5)),
          .inventedLength = wrongShare(result, reference, options, progress.part(0.5, 1)),
          .connections = here.size(),
          .missedConnections = shareLacking(here, there),
          .inventedConnections = shareLacking(there, here)};
}

} // namespace espalier
