#include "core/evaluate/registration/shift_votes.h"

#include "core/base/spatial_index.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace espalier {
namespace {

/// Hears the votes of places of `from` for shifts to places of `to`.
class Votes {
public:
  Votes(const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to)
      : from_(from), to_(to), places_(about(to)), index_(places_) {}

  /// Calls visit(shift) for each pair whose shift is within `radius` of `center`.
  template <class Visit>
  void within(const Eigen::Vector3d& center, double radius, const Visit& visit) const {
    constexpr std::size_t mostVoters = 1000;
    const std::size_t voters = std::min(from_.size(), mostVoters);
    for (std::size_t k = 0; k < voters; ++k) {
      const Eigen::Vector3d& voter = from_[k * from_.size() / voters];
      const Eigen::Vector3f place = (voter + center - to_.front()).cast<float>();
      for (const Neighbor& found : index_.within(place, static_cast<float>(radius)))
        visit(to_[static_cast<std::size_t>(found.index)] - voter);
    }
  }

private:
  /// About the first of them: floats would blur places far from their origin.
  static Eigen::Matrix3Xf about(const std::vector<Eigen::Vector3d>& places) {
    Eigen::Matrix3Xf result(3, static_cast<Eigen::Index>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i)
      result.col(static_cast<Eigen::Index>(i)) = (places[i] - places.front()).cast<float>();
    return result;
  }

  const std::vector<Eigen::Vector3d>& from_;
  const std::vector<Eigen::Vector3d>& to_;
  Eigen::Matrix3Xf places_; // of to_; what the index refers to
  SpatialIndex index_;
};

/// Counts votes in the cells of a cube of side 2 x radius about a center.
class Tally {
public:
  Tally(Eigen::Vector3d center, double radius, double side)
      : low_(center.array() - radius), center_(std::move(center)),
        cells_(std::clamp(static_cast<int>(std::ceil(2 * radius / side)), 2, mostCells)),
        side_(2 * radius / cells_), counts_(static_cast<std::size_t>(cells_) * cells_ * cells_, 0) {
  }

  void add(const Eigen::Vector3d& vote) {
    const Eigen::Array3i cell =
        ((vote.array() - low_) / side_).floor().cast<int>().max(0).min(cells_ - 1);
    ++counts_[place(cell.x(), cell.y(), cell.z())];
  }

  /// Center of the fullest cube of 2 x 2 x 2 cells, the one nearest the middle on a tie. Cubes
  /// overlap, so that none of their walls splits a cluster everywhere. None without votes.
  [[nodiscard]] std::optional<Eigen::Vector3d> fullest() const {
    std::optional<Eigen::Vector3d> best;
    std::uint32_t most = 0;
    for (int x = 0; x + 1 < cells_; ++x)
      for (int y = 0; y + 1 < cells_; ++y)
        for (int z = 0; z + 1 < cells_; ++z) {
          const std::uint32_t count = cubeAt(x, y, z);
          if (count == 0 || count < most) continue;
          const Eigen::Vector3d at = low_ + side_ * Eigen::Array3d(x + 1, y + 1, z + 1);
          if (count > most || (at - center_).norm() < (*best - center_).norm()) best = at;
          most = count;
        }
    return best;
  }
  [[nodiscard]] double cellSide() const { return side_; }

private:
  static constexpr int mostCells = 200; // along a side: 32 MB

  [[nodiscard]] std::size_t place(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * cells_ + y) * cells_ + z;
  }
  [[nodiscard]] std::uint32_t cubeAt(int x, int y, int z) const {
    std::uint32_t count = 0;
    for (int corner = 0; corner < 8; ++corner)
      count += counts_[place(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2 & 1))];
    return count;
  }

  Eigen::Array3d low_;
  Eigen::Vector3d center_;
  int cells_; // along a side
  double side_;
  std::vector<std::uint32_t> counts_;
};

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
  const Votes votes(from, to);
  Tally tally(about, radius, width / 2);
  votes.within(about, radius, [&](const Eigen::Vector3d& vote) { tally.add(vote); });
  const auto cube = tally.fullest();
  if (!cube) return std::nullopt;

  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  votes.within(*cube, std::sqrt(3.0) * tally.cellSide() * 1.01, [&](const Eigen::Vector3d& vote) {
    if ((vote - *cube).cwiseAbs().maxCoeff() > tally.cellSide() * 1.01) return;
    sum += vote;
    ++count;
  });
  return count > 0 ? sum / count : *cube;
}

} // namespace espalier
