#pragma once

#include "core/base/shown_message.h"
#include "core/io/formats.h"

#include <vector>

namespace espalier {

/// What a file of this format would not keep of this skeleton, a plain sentence each: "SWC keeps no
/// edge types: ...". None if it keeps all. What none of them keeps, as review marks, is listed,
/// too. pre: format.content is Content::structure Time O(N).
[[nodiscard]] std::vector<ShownMessage> droppedBy(const Format& format, const Skeleton& skeleton);

/// The same of a structure, which may be a plant without its shape.
[[nodiscard]] std::vector<ShownMessage> droppedBy(const Format& format, const Structure& structure);

} // namespace espalier
