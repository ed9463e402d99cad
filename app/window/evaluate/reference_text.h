#pragma once

#include "core/skeleton/skeleton.h"

#include <QString>

#include <string>
#include <vector>

namespace espalier {

/// The structure that the plant is compared with.
struct Reference {
  Skeleton skeleton;
  QString path;                       // of the file it was read from; of a version: its name
  bool isVersion = false;             // a state of the plant itself, which lies where it is
  bool isOfScan = false;              // of a project of the same scan, which lies where it is, too
  std::vector<Reference> before = {}; // what a version stands in the place of: none, or one
  bool operator==(const Reference&) const = default;
};

/// As a project keeps it, exactly: {"path": "...", "version": true, "of_scan": true, "nodes":
/// [[parent, "<", x, y, z, radius], ...], "before": {another}}, where a parent is the number of a
/// node before, -1 for a root. Ids are not kept, nor what an MTG says of nodes. Empty without
/// nodes.
[[nodiscard]] std::string textOf(const Reference& reference);

/// @throws Error if it is no such text
[[nodiscard]] Reference referenceFrom(const std::string& text);

} // namespace espalier
