#pragma once

#include "core/base/random.h"
#include "core/skeleton/skeleton_delta.h"

namespace espalier::test {

/// One change, drawn at random, of any kind that an editor can make. A plant of few nodes grows.
void editAtRandom(SkeletonEditor& editor, Random& random);

} // namespace espalier::test
