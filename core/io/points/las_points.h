#pragma once

#include "core/io/points/las_header.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/read_options.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace espalier {

/// What is taken of a point of a LAS file, as it lies there.
struct LasPoint {
  std::array<std::int32_t, 3> position{}; // before scale and offset
  std::array<std::uint16_t, 3> color{};
  std::uint16_t intensity = 0;
  bool isWithheld = false;
};

/// The point at `bytes`. pre: header.pointLength bytes are there
[[nodiscard]] LasPoint lasPointAt(const char* bytes, const LasHeader& header);

/// Gathers the points of a LAS file, compressed or not.
class LasPoints {
public:
  /// @param expected  how many points will come, as far as the bytes of the file can hold them
  /// @param chooser   says which are kept; must outlive this
  LasPoints(const LasHeader& header, std::uint64_t expected, PartChooser& chooser);

  void add(const LasPoint& point);
  [[nodiscard]] std::size_t size() const { return points_.size(); } // kept so far

  /// Without intensities or colors that are all 0. Withheld points are left out, with a note.
  [[nodiscard]] ImportedPoints finish(const std::string& file) &&;

private:
  LasHeader header_;
  PartChooser* chooser_;
  PointCollector points_;
  std::uint64_t withheld_ = 0;
};

} // namespace espalier
