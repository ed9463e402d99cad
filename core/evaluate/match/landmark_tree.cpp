#include "core/evaluate/match/landmark_tree.h"

#include "core/evaluate/match/landmark_agreement.h"

namespace espalier {
namespace {

/// Pairs the landmarks of one kind; by landmark of the result.
void pairKind(const std::vector<Landmark>& result, const std::vector<Landmark>& reference,
              bool isTip, double distance, Partners& partners) {
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

} // namespace

std::vector<Landmark> landmarksOf(const Skeleton& skeleton) {
  std::vector<Landmark> found;
  std::vector<std::optional<std::size_t>> last(
      skeleton.idEnd());                           // by node: the landmark at it, or else below it
  std::vector<double> length(skeleton.idEnd(), 0); // by node: of the path from there
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    const std::size_t children = skeleton.children(id).size();
    std::optional<std::size_t> below;
    double pathLength = 0;
    if (node.parent) {
      const std::size_t parent = indexOf(*node.parent);
      below = last[parent];
      pathLength = length[parent] + (node.position - skeleton[*node.parent].position).norm();
    }
    const bool isTip = node.parent && children == 0;
    if (isTip || children > 1) {
      last[indexOf(id)] = found.size();
      found.push_back({node.position, isTip, below, pathLength, isTip ? 1.0 : 0.0});
    } else {
      last[indexOf(id)] = below;
      length[indexOf(id)] = pathLength;
    }
  }
  for (std::size_t i = found.size(); i-- > 0;)
    if (found[i].below) found[*found[i].below].carried += found[i].carried;
  return found;
}

Partners partnersOf(const std::vector<Landmark>& result, const std::vector<Landmark>& reference,
                    double distance) {
  Partners partners(result.size());
  for (const bool isTip : {false, true})
    pairKind(result, reference, isTip, distance, partners);
  return partners;
}

std::vector<PathBelow> pathsBelow(const std::vector<Landmark>& landmarks,
                                  const Partners& partners) {
  std::vector<PathBelow> paths;
  for (const Landmark& landmark : landmarks) { // those below come first
    PathBelow path{landmark.below, landmark.length};
    if (landmark.below && !partners[*landmark.below]) {
      path = paths[*landmark.below];
      path.length += landmark.length;
    }
    paths.push_back(path);
  }
  return paths;
}

} // namespace espalier
