#pragma once

#include "core/cloud/point_cloud.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// What a column of a point file holds.
enum class PointField : std::uint8_t {
  none,
  x,
  y,
  z,
  intensity,
  red,
  green,
  blue,
  packedColor,
  station
};

/// The field that a column of this name holds in the files of scanners and of other programs:
/// "x", "Intensity", "scalar_Intensity", "diffuse_red", "R" ... Case does not matter.
[[nodiscard]] PointField pointFieldNamed(std::string_view name);

/// The values of one point by field; those of `none` mean nothing.
using PointValues = std::array<double, 10>;

[[nodiscard]] constexpr std::size_t indexOf(PointField field) {
  return static_cast<std::size_t>(field);
}

/// Gathers the points of a file, whatever its format.
///
/// Colors may be bytes, words of 16 bits, or fractions of 1: the largest decides which. Numbers of
/// stations that are not all whole and from 0 to 65535 mean something else and are passed over.
class PointCollector {
public:
  /// @param fields    what the file has of each point; x, y and z are taken for granted
  /// @param expected  how many points will come, as far as the file was found to be long enough
  PointCollector(const std::vector<PointField>& fields, std::size_t expected);

  void add(const PointValues& values);
  [[nodiscard]] std::size_t size() const { return points_.positions.size(); }

  /// @param mayBeFractions  whether colors that are nowhere above 1 are fractions of 1
  /// @param stations  those that numbers of stations count in; too short a list counts for none:
  ///                  then there is one station for each number, named by it
  [[nodiscard]] RawPoints finish(bool mayBeFractions, std::vector<Station> stations = {}) &&;

private:
  void nameStations(std::vector<Station> stations);

  RawPoints points_;
  std::vector<std::array<float, 3>> colors_;
  bool hasColors_ = false;
  bool hasPackedColors_ = false;
  bool hasIntensities_ = false;
  bool hasStations_ = false;
};

/// Drops intensities and colors that are 0 everywhere: scanners without a radiometer or a camera
/// fill in zeros.
void dropEmptyColumns(RawPoints& points);

/// Checks the count in a header against the bytes that are there, before memory is taken for it.
///
/// @param file      name for the message
/// @param count     points promised
/// @param size      the least number of bytes of a point, > 0
/// @param available bytes in which they should lie
/// @throws Error if they do not fit, or are more than a PointCloud can hold
void checkPromise(const std::string& file, std::uint64_t count, std::uint64_t size,
                  std::uint64_t available);

/// @throws Error if a PointCloud cannot hold so many points
void checkPointCount(const std::string& file, std::uint64_t count);

} // namespace espalier
