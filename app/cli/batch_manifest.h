#pragma once

#include "core/base/imported.h"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// A plant of a batch: one line of its manifest.
struct BatchPlant {
  std::string name; // of its result, without folder and extension
  std::filesystem::path scan;
  std::filesystem::path reference;     // empty: the result is not judged
  std::optional<Eigen::Vector3d> root; // [L], frame of the scan; none: the lowest point
  std::string problem;                 // of its line, which it names; empty: none
};

/// Reads which plants to reconstruct: a CSV table with a column `scan`, and those of `name`,
/// `reference` and `root` that are needed. Other columns are passed over, with a note.
///
/// A plant without a name is named as its scan. Files are sought from the folder of the manifest.
/// A root is "X,Y,Z" in quotes, "X;Y;Z" or "X Y Z", or lowest.
///
/// A plant has a problem if no scan is named, if its name came before or is none for a file, or if
/// its root is no place. Whether the files exist is not looked at. All names are different: one
/// whose own name cannot be used is named after its line.
///
/// @throws Error if the table cannot be read, has no column `scan`, or lists no plant
[[nodiscard]] Imported<std::vector<BatchPlant>> readManifest(const std::filesystem::path& file);

} // namespace espalier
