#pragma once

#include "core/surface/envelopes/envelope.h"

namespace espalier {

/// The convex hull of a crown. Parameter: its corners. O(corners).
[[nodiscard]] Envelope convexEnvelope(const Crown& crown);

} // namespace espalier
