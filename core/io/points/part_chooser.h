#pragma once

#include "core/cloud/point_cloud.h"
#include "core/io/points/read_options.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace espalier {

/// Chooses the points of a part of a scan while these are met one after another.
///
/// Each place in a file has a rank of its own, which looks drawn by lot and is always the same. The
/// `most` points of lowest rank are kept. So a smaller part holds none that a larger one lacks, and
/// no more than one and a half times what is kept need be in memory at a time.
class PartChooser {
public:
  /// Of points before it in rank nothing is known; see ReadOptions.
  explicit PartChooser(const ReadOptions& options);

  [[nodiscard]] bool isPart() const { return isLimited() || box_.has_value(); }
  [[nodiscard]] bool isLimited() const { return most_ > 0; }

  /// Passes over points that are not offered: they are marked as invalid, or have no position.
  void pass(std::uint64_t points = 1) { place_ += points; }

  /// Goes on at a place in the file; points of a coarser level are before all of a finer one.
  void goTo(std::uint64_t place, unsigned level);

  /// The rank of the next point, if it is kept as far as those before show. Of a part, points that
  /// are out of range (isInRange) are not.
  [[nodiscard]] std::optional<std::uint64_t> offer(const Eigen::Vector3d& position);

  /// Room to take for points, of which there are `count` in the file.
  [[nodiscard]] std::size_t roomFor(std::uint64_t count) const;

  /// Whether so many kept points should be reduced now.
  [[nodiscard]] bool areMany(std::size_t points) const { return points > crowd_; }
  /// Whether there are as many as are asked for.
  [[nodiscard]] bool areEnough(std::size_t points) const { return isLimited() && points >= most_; }

  /// Learns from the ranks of points that were kept which are to stay, should they be too many.
  void learn(const std::vector<std::uint64_t>& ranks);

  [[nodiscard]] std::uint64_t met() const { return place_; } // points of the file, so far

private:
  template <class Value>
  friend void keepThoseThatStay(std::vector<Value>& values, const std::vector<std::uint64_t>& ranks,
                                const PartChooser& chooser);
  friend void keepThoseThatStay(RawPoints& points, std::vector<std::uint64_t>& ranks,
                                const PartChooser& chooser);
  [[nodiscard]] bool stays(std::uint64_t rank) const { return rank <= limit_; }

  std::uint64_t most_;
  std::optional<Eigen::AlignedBox3d> box_;
  std::size_t crowd_ = std::numeric_limits<std::size_t>::max();
  std::uint64_t place_ = 0;
  std::uint64_t level_ = 0;
  std::uint64_t limit_ = std::numeric_limits<std::uint64_t>::max() - 1; // all ranks are below
};

/// Leaves in `values`, which are one per rank or none, those whose ranks stay.
template <class Value>
void keepThoseThatStay(std::vector<Value>& values, const std::vector<std::uint64_t>& ranks,
                       const PartChooser& chooser) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i)
    if (chooser.stays(ranks[i])) values[kept++] = values[i];
  values.resize(kept);
}

/// The same of all that points have, and of their ranks at last.
void keepThoseThatStay(RawPoints& points, std::vector<std::uint64_t>& ranks,
                       const PartChooser& chooser);

/// Stations that no point is from are not listed; if one is left, all points are from it.
void dropEmptyStations(RawPoints& points);

/// The part of points that were all read, as if they had been chosen while they were: for formats
/// that cannot be read in pieces.
[[nodiscard]] RawPoints partOf(RawPoints points, const ReadOptions& options);

} // namespace espalier
