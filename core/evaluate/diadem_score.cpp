#include "core/evaluate/diadem_score.h"

#include "core/evaluate/landmark_agreement.h"

#include <Eigen/Core>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

namespace espalier {
namespace {

using Index = std::optional<std::size_t>;

/// A tip or a branching.
struct Landmark {
  Eigen::Vector3d position;
  bool isTip;
  Index below;        // the landmark it stands on, if any
  double length;      // of the way from there, or from the root [L]
  double carried = 0; // tips at or above it
};

/// The landmarks of a skeleton, each after the one it stands on.
std::vector<Landmark> landmarksOf(const Skeleton& skeleton) {
  std::vector<Landmark> found;
  std::vector<Index> last(skeleton.idEnd());       // by node: the landmark at it, or else below it
  std::vector<double> length(skeleton.idEnd(), 0); // by node: of the way from there
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    const std::size_t children = skeleton.children(id).size();
    Index below;
    double way = 0;
    if (node.parent) {
      const std::size_t parent = indexOf(*node.parent);
      below = last[parent];
      way = length[parent] + (node.position - skeleton[*node.parent].position).norm();
    }
    const bool isTip = node.parent && children == 0;
    if (isTip || children > 1) {
      last[indexOf(id)] = found.size();
      found.push_back({node.position, isTip, below, way, isTip ? 1.0 : 0.0});
    } else {
      last[indexOf(id)] = below;
      length[indexOf(id)] = way;
    }
  }
  for (std::size_t i = found.size(); i-- > 0;)
    if (found[i].below) found[*found[i].below].carried += found[i].carried;
  return found;
}

/// Pairs the landmarks of one kind; by landmark of the result.
void pairKind(const std::vector<Landmark>& result, const std::vector<Landmark>& reference,
              bool isTip, double distance, std::vector<Index>& partners) {
  const auto ofKind = [&](const std::vector<Landmark>& from) {
    std::vector<std::size_t> kind;
    for (std::size_t i = 0; i < from.size(); ++i)
      if (from[i].isTip == isTip) kind.push_back(i);
    return kind;
  };
  const auto places = [](const std::vector<Landmark>& from, const std::vector<std::size_t>& kind) {
    std::vector<Eigen::Vector3d> positions;
    positions.reserve(kind.size());
    for (const std::size_t i : kind)
      positions.push_back(from[i].position);
    return positions;
  };
  const std::vector<std::size_t> rows = ofKind(result);
  const std::vector<std::size_t> columns = ofKind(reference);
  const auto pairs = landmarkPairs(places(result, rows), places(reference, columns), distance);
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (pairs[k]) partners[rows[k]] = columns[*pairs[k]];
}

/// The way down to the nearest landmark with a partner.
struct WayBelow {
  Index landmark; // none: there is none below
  double length;  // [L]
};

std::vector<WayBelow> waysBelow(const std::vector<Landmark>& landmarks,
                                const std::vector<Index>& partners) {
  std::vector<WayBelow> ways;
  for (const Landmark& landmark : landmarks) { // those below come first
    WayBelow way{landmark.below, landmark.length};
    if (landmark.below && !partners[*landmark.below]) {
      way = ways[*landmark.below];
      way.length += landmark.length;
    }
    ways.push_back(way);
  }
  return ways;
}

/// What is invented, in unpaired tips that unpaired landmarks are or carry.
double excess(const std::vector<Landmark>& landmarks, const std::vector<Index>& partners) {
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
  std::vector<Index> partners(found.size());
  for (const bool isTip : {false, true})
    pairKind(found, truth, isTip, options.distance, partners);
  std::vector<Index> inverse(truth.size());
  for (std::size_t i = 0; i < partners.size(); ++i)
    if (partners[i]) inverse[*partners[i]] = i;

  DiademScore score{.distance = options.distance, .landmarks = truth.size()};
  const std::vector<WayBelow> foundWays = waysBelow(found, partners);
  const std::vector<WayBelow> trueWays = waysBelow(truth, inverse);
  double all = excess(found, partners);
  double right = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    all += truth[i].carried;
    if (!inverse[i]) continue;
    ++score.matched;
    const WayBelow& there = foundWays[*inverse[i]];
    const WayBelow& here = trueWays[i];
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
