#pragma once

#include "core/base/imported.h"
#include "core/io/bytes/xml.h"
#include "core/io/points/e57_fields.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// One scan of an E57 file, as the XML describes it.
struct E57Scan {
  std::vector<E57Field> fields;
  std::uint64_t start = 0;                                // of its section, a place in the file
  std::uint64_t records = 0;                              // > 0
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(); // from the scanner to the frame of all
  std::string name;                                       // empty: none
  bool hasPose = false;                                   // else the frame may be any
  std::optional<std::array<E57Limits, 3>> colorLimits;    // of red, green and blue, where known
};

/// The scans of a file that have points, with a note on each that cannot be turned by its pose.
/// @throws Error naming the line of the XML that is wrong
[[nodiscard]] Imported<std::vector<E57Scan>> e57ScansOf(const XmlFile& xml);

} // namespace espalier
