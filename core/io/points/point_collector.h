#pragma once

#include "core/base/shown_message.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/part_chooser.h"
#include "core/io/points/point_field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace espalier {

/// The values of one point by field; those of `none` mean nothing.
using PointValues = std::array<double, 10>;

/// Gathers the points of a file that are kept of it, whatever its format.
///
/// Colors may be bytes, words of 16 bits, or fractions of 1: the largest decides which, be it of a
/// point that is kept or not. Numbers of stations that are not all whole and from 0 to 65535 mean
/// something else and are passed over.
class PointCollector {
public:
  /// @param fields    what the file has of each point; x, y and z are taken for granted
  /// @param expected  how many points will come, as far as the file was found to be long enough
  /// @param chooser   says which are kept; must outlive the collector
  PointCollector(const std::vector<PointField>& fields, std::uint64_t expected,
                 PartChooser& chooser);

  /// Adds the next point of the file, if it is to be kept.
  void add(const PointValues& values);
  [[nodiscard]] std::size_t size() const { return points_.positions.size(); } // kept so far

  /// Leaves out those that points behind them made too many.
  void reduce();
  /// By point; none if there is no limit to their number.
  [[nodiscard]] const std::vector<std::uint64_t>& ranks() const { return ranks_; }

  /// @param mayBeFractions  whether colors that are nowhere above 1 are fractions of 1
  /// @param stations  those that numbers of stations count in; too short a list counts for none:
  ///                  then there is one station for each number, named by it
  [[nodiscard]] RawPoints finish(bool mayBeFractions, std::vector<Station> stations = {}) &&;

private:
  void nameStations(std::vector<Station> stations);

  void addColor(const PointValues& values);

  PartChooser* chooser_;
  RawPoints points_;
  std::vector<std::uint64_t> ranks_;
  std::vector<std::array<float, 3>> colors_;
  float largestColor_ = 0;
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
/// @param where     in the file it is promised, for the message
/// @param count     points promised
/// @param size      the least number of bytes of a point, > 0
/// @param available bytes in which they should lie
/// @throws Error if they do not fit, or are more than a PointCloud can hold
void checkPromise(const FilePlace& where, std::uint64_t count, std::uint64_t size,
                  std::uint64_t available);

/// What to say of a file that ends before its size when it was opened.
[[nodiscard]] ShownError becameShorter(const std::string& file);

/// @throws Error if a PointCloud cannot hold so many points
void checkPointCount(const FilePlace& where, std::uint64_t count);

} // namespace espalier
