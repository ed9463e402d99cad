#pragma once

#include "core/io/bytes/byte_source.h"
#include "core/io/points/point_field.h"
#include "core/io/points/point_glance.h"

#include <string>
#include <vector>

namespace espalier {

// Each says what a file of its format holds, by its header and a few places of it: never by all of
// a file over some MB. Of unit and axis it says only what the file or its format states.
// @param file  its name, for messages
// @throws Error as the reader of the format, if the header is damaged

[[nodiscard]] PointGlance glanceAtLas(ByteSource& source, const std::string& file); // and LAZ
[[nodiscard]] PointGlance glanceAtPly(ByteSource& source, const std::string& file);
[[nodiscard]] PointGlance glanceAtPcd(ByteSource& source, const std::string& file);
[[nodiscard]] PointGlance glanceAtXyz(ByteSource& source, const std::string& file,
                                      const std::vector<PointField>& columns = {});
[[nodiscard]] PointGlance glanceAtPtx(ByteSource& source, const std::string& file);
[[nodiscard]] PointGlance glanceAtE57(ByteSource& source, const std::string& file);

} // namespace espalier
