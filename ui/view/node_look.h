#pragma once

#include "ui/view/color_map.h"

#include <vector>

namespace espalier {

/// What nodes, each with the edge to its parent, are colored by.
struct NodeColors {
  std::vector<float> values; // by id; not a number, or none: drawn as usual
  Legend legend;
};

} // namespace espalier
