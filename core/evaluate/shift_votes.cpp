#include "core/evaluate/shift_votes.h"

#include "core/base/spatial_index.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace espalier {
namespace {

/// Differences of pairs, less `about`, that are within `radius` of it.
std::vector<Eigen::Vector3d> votes(const std::vector<Eigen::Vector3d>& from,
                                   const std::vector<Eigen::Vector3d>& to,
                                   const Eigen::Vector3d& about, double radius) {
  constexpr std::size_t mostVoters = 1000;
  const Eigen::Vector3d& origin = to.front(); // the index holds floats: far frames would blur them
  Eigen::Matrix3Xf places(3, static_cast<Eigen::Index>(to.size()));
  for (std::size_t i = 0; i < to.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = (to[i] - origin).cast<float>();
  const SpatialIndex index(places);

  std::vector<Eigen::Vector3d> result;
  const std::size_t voters = std::min(from.size(), mostVoters);
  for (std::size_t k = 0; k < voters; ++k) {
    const Eigen::Vector3d voter = from[k * from.size() / voters] + about;
    const Eigen::Vector3f place = (voter - origin).cast<float>();
    for (const Neighbor& neighbor : index.within(place, static_cast<float>(radius)))
      result.emplace_back(to[static_cast<std::size_t>(neighbor.index)] - voter);
  }
  return result;
}

using Cell = Eigen::Array3i;

Cell cellOf(const Eigen::Vector3d& vote, double side) {
  return (vote / side).array().floor().cast<int>();
}

/// Orders cells. pre: coordinates within 2^20 of zero
std::uint64_t keyOf(const Cell& cell) {
  const Eigen::Array<std::uint64_t, 3, 1> place = (cell + (1 << 20)).cast<std::uint64_t>();
  return place[0] << 42 | place[1] << 21 | place[2];
}

struct CubeVote {
  std::uint64_t cube;
  std::uint32_t vote;
  bool operator<(const CubeVote& other) const {
    return cube != other.cube ? cube < other.cube : vote < other.vote;
  }
};

/// One entry per vote and per cube of 2 x 2 x 2 cells that holds it, by cube; cubes overlap, so
/// that none of their walls splits a cluster everywhere. A cube is named by its lowest cell.
std::vector<CubeVote> votesByCube(const std::vector<Eigen::Vector3d>& votes, double side) {
  std::vector<CubeVote> result;
  result.reserve(8 * votes.size());
  for (std::uint32_t vote = 0; vote < votes.size(); ++vote)
    for (int corner = 0; corner < 8; ++corner) {
      const Cell lower(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      result.push_back({keyOf(cellOf(votes[vote], side) - lower), vote});
    }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

std::vector<Eigen::Vector3d> landmarks(const Skeleton& skeleton) {
  std::vector<Eigen::Vector3d> result;
  for (const NodeId id : skeleton.ids())
    if (!skeleton[id].parent || skeleton.children(id).size() != 1)
      result.push_back(skeleton[id].position);
  return result;
}

std::optional<Eigen::Vector3d> votedShift(const std::vector<Eigen::Vector3d>& from,
                                          const std::vector<Eigen::Vector3d>& to,
                                          const Eigen::Vector3d& about, double radius,
                                          double width) {
  if (from.empty() || to.empty()) return std::nullopt;
  const std::vector<Eigen::Vector3d> all = votes(from, to, about, radius);
  if (all.empty()) return std::nullopt;
  const double side = std::max(width / 2, radius / (1 << 19)); // keyOf counts to 2^20
  const std::vector<CubeVote> cubes = votesByCube(all, side);

  std::ptrdiff_t most = 0;
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  for (auto begin = cubes.begin(); begin != cubes.end();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    auto end = begin;
    for (; end != cubes.end() && end->cube == begin->cube; ++end)
      sum += all[end->vote];
    const Eigen::Vector3d mean = sum / static_cast<double>(end - begin);
    if (end - begin > most || (end - begin == most && mean.squaredNorm() < best.squaredNorm())) {
      most = end - begin;
      best = mean;
    }
    begin = end;
  }
  return about + best;
}

} // namespace espalier
