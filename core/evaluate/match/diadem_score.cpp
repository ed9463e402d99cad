#include "core/evaluate/match/diadem_score.h"

#include "core/evaluate/match/landmark_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

namespace espalier {
namespace {

/// What is invented, in unpaired tips that unpaired landmarks are or carry.
double excess(const std::vector<Landmark>& landmarks, const Partners& partners) {
  std::vector<double> carried(landmarks.size(), 0);
  double sum = 0;
  for (std::size_t i = landmarks.size(); i-- > 0;) {
    if (landmarks[i].isTip && !partners[i]) carried[i] = 1;
    if (!partners[i]) sum += carried[i];
    if (landmarks[i].below) carried[*landmarks[i].below] += carried[i];
  }
  return sum;
}

} // namespace

DiademScore diademScore(const Skeleton& result, const Skeleton& reference,
                        const DiademOptions& options) {
  assert(options.distance > 0 && options.lengthShare >= 0);
  const std::vector<Landmark> found = landmarksOf(result);
  const std::vector<Landmark> truth = landmarksOf(reference);
  const Partners partners = partnersOf(found, truth, options.distance);
  const Partners back = inverse(partners, truth.size());

  DiademScore score{.distance = options.distance, .landmarks = truth.size()};
  const std::vector<PathBelow> foundPaths = pathsBelow(found, partners);
  const std::vector<PathBelow> truePaths = pathsBelow(truth, back);
  double all = excess(found, partners);
  double right = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    all += truth[i].carried;
    if (!back[i]) continue;
    ++score.matched;
    const PathBelow& there = foundPaths[*back[i]];
    const PathBelow& here = truePaths[i];
    const bool isSame =
        (there.landmark ? partners[*there.landmark] : std::nullopt) == here.landmark;
    const double slack = options.distance + options.lengthShare * here.length;
    if (!isSame || (here.landmark && std::abs(there.length - here.length) > slack)) continue;
    ++score.connected;
    right += truth[i].carried;
  }
  score.score = all > 0 ? right / all : 1;
  return score;
}

} // namespace espalier
