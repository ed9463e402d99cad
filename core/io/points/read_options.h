#pragma once

#include "core/base/imported.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/point_field.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// What is to be read of a file of points: all of it, unless something else is asked for.
///
/// Which points are read depends on the file and on this alone, not on threads or on how the file
/// is read. With both, it is `most` of the points that lie in the box.
struct ReadOptions {
  /// So many points at most; 0: all. They are chosen by their place in the file, as a lot decides
  /// that is always drawn alike (PartChooser). Of a COPC file, whose points lie in an octree, whole
  /// levels are taken, the coarsest first, and of the first that is too many as the lot decides.
  std::uint64_t most = 0;
  /// All points in it, its faces included [L], frame of the file; none: wherever they lie.
  std::optional<Eigen::AlignedBox3d> box = std::nullopt;
  /// What each column of a text file holds; none: found out. Other formats name their own.
  std::vector<PointField> columns = {};

  [[nodiscard]] bool isPart() const { return most > 0 || box.has_value(); }
};

/// What was read of a file of points.
struct ImportedPoints : Imported<RawPoints> {
  std::uint64_t listed = 0; // points of the file, whether they were asked for or not
};

} // namespace espalier
