#pragma once

#include "core/base/random.h"
#include "core/skeleton/skeleton_delta.h"

#include <string>

namespace espalier::test {

/// One change, drawn at random, of any kind that an editor can make, edits by hand among them. A
/// plant of few nodes grows.
void editAtRandom(SkeletonEditor& editor, Random& random);

/// One edit by hand, drawn at random of all there are; a plant of few nodes grows, one of many is
/// cut back. Nodes of scale 3 may be parts of units of scales 1 and 2.
struct HandEdit {
  std::string name;
  bool isRefused = false; // by an Error; then it has changed nothing
  bool keepsUnits = true; // or is it about what is part of what?
};
HandEdit editByHandAtRandom(SkeletonEditor& editor, Random& random);

} // namespace espalier::test
