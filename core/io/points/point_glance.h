#pragma once

#include "core/base/shown_message.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace espalier {

/// A column of a file of points.
struct GlanceColumn {
  std::string name;     // as the file has it, else what it is taken for
  std::string type;     // as the format names it: "double", "uint16"; "text" of numbers in a text
  bool isTaken = false; // by the reader; others are left out
};

/// What is known of the unit or of the axis that points up.
struct GlanceGuess {
  std::string value;     // "mm", "cm", "m"; "x", "y", "z"; empty: not known
  ShownMessage reason;   // in a few words
  bool isStated = false; // by the file or its format, rather than guessed
};

/// What a file of points holds, found out without reading it all.
struct PointGlance {
  ShownMessage version; // of the format and how it is written: "1.4, point format 7"
  bool isCompressed = false;
  std::uint64_t points = 0; // listed in the file
  bool arePointsEstimated = false;
  std::vector<GlanceColumn> columns;
  std::vector<ShownMessage> leftOut; // what else the file has: "12 images"
  Eigen::AlignedBox3d bounds;        // [L], frame of the file; empty: not known
  bool areBoundsOfSample = false;    // so that the points may reach a little farther
  std::uint64_t stations = 1;        // 0: not known
  bool isReadWhole = false;          // nothing less shows it
  GlanceGuess unit;
  GlanceGuess up;
  std::vector<Eigen::Vector3d> sample; // places of some points from all parts of the file [L]
};

} // namespace espalier
