#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

using Color = std::array<std::uint8_t, 3>; // red, green, blue

/// A place that a scanner measured from.
struct Station {
  std::string name;                       // of people's choice
  std::optional<Eigen::Vector3d> scanner; // where it stood [L], frame of the file; none: not known

  bool operator==(const Station&) const = default;
};

/// A place in a list of stations.
using StationIndex = std::uint16_t;
inline constexpr std::size_t mostStations = std::size_t{1} << 16;

/// Points as a file lists them, before they become a PointCloud.
struct RawPoints {
  std::vector<Eigen::Vector3d> positions; // [L], in the frame of the file
  std::vector<Color> colors;              // one per point, or none
  std::vector<float> intensities;         // one per point, or none
  std::vector<Station> stations = {};     // none: not known
  /// Which of the stations each point is from, one per point; none if there is one station or none.
  std::vector<StationIndex> stationOf = {};
};

/// What a PointCloud holds, as it was when it was stored.
struct StoredPoints {
  Eigen::Matrix3Xf positions;                       // 3 x N about `origin` [L]
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); // [L], frame of the file
  std::vector<Color> colors;                        // N, or none
  std::vector<float> intensities;                   // N, or none
  std::vector<std::uint32_t> fileOrder;             // N
  std::vector<Station> stations = {};
  std::vector<StationIndex> stationOf = {}; // N, or none if there is one station or none
};

/// The samples of a laser scanner. Immutable once made; shared as shared_ptr<const PointCloud>.
///
/// Invariants: all positions are finite; colors() and intensities() are empty or have one entry per
/// point, and so has stationOf(), which is empty unless there are two stations and more. Points are
/// sorted along a space-filling curve, so that near points are near in memory.
class PointCloud {
public:
  PointCloud() = default;

  /// Points that are not finite, or beyond largestCoordinate, are left out: size() then is less
  /// than raw.positions.size(). Time O(N log N).
  explicit PointCloud(RawPoints raw, const Progress& progress = {});

  /// The same cloud again, in the order that it had. Time O(N).
  /// @throws Error if the parts are not of one size, or a position is not finite
  explicit PointCloud(StoredPoints stored);

  [[nodiscard]] Eigen::Index size() const { return positions_.cols(); }
  [[nodiscard]] bool isEmpty() const { return size() == 0; }

  /// 3 x N about origin() [L], the middle of all but far points: plants under 10 km keep 1 mm.
  [[nodiscard]] const Eigen::Matrix3Xf& positions() const { return positions_; }
  [[nodiscard]] const Eigen::Vector3d& origin() const { return origin_; } // [L], frame of the file
  [[nodiscard]] const std::vector<Color>& colors() const { return colors_; }
  [[nodiscard]] const std::vector<float>& intensities() const { return intensities_; }

  /// The stations that the points were measured from; empty if none are known.
  [[nodiscard]] const std::vector<Station>& stations() const { return stations_; }
  [[nodiscard]] const std::vector<StationIndex>& stationOf() const { return stationOf_; }
  /// The place in stations() of that which a point is from. pre: there are stations
  [[nodiscard]] std::size_t stationOf(Eigen::Index point) const {
    return stationOf_.empty() ? 0 : stationOf_[static_cast<std::size_t>(point)];
  }

  /// Where each point stood in the file.
  [[nodiscard]] const std::vector<std::uint32_t>& fileOrder() const { return fileOrder_; }

  /// Position in the frame of the file [L].
  [[nodiscard]] Eigen::Vector3d position(Eigen::Index point) const {
    return positions_.col(point).cast<double>() + origin_;
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const; // [L], frame of the file; empty without points

private:
  Eigen::Matrix3Xf positions_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::vector<Color> colors_;
  std::vector<float> intensities_;
  std::vector<std::uint32_t> fileOrder_;
  std::vector<Station> stations_;
  std::vector<StationIndex> stationOf_;
};

/// Mean distance from a place to the nearest other [L], without strays (spacing_of_places.h): the
/// unit of the default rules. Over at most 20 000 places, spread evenly. 0 if all coincide.
[[nodiscard]] double pointSpacing(const Eigen::Matrix3Xf& points, const Progress& progress = {});
/// The same, where there is an index of the points.
[[nodiscard]] double pointSpacing(const Eigen::Matrix3Xf& points, const SpatialIndex& index);

} // namespace espalier
