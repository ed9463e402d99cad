#pragma once

#include <filesystem>
#include <fstream>

namespace espalier {

/// Files that a user names are asked for here, so that one that is missing, a folder, or not to be
/// read is told of in the same words everywhere. Opens nothing.
/// @throws Error which file, why it cannot be read, and what to try
void requireReadable(const std::filesystem::path& path);

/// The bytes of a file. @throws Error as requireReadable
[[nodiscard]] std::ifstream openForReading(const std::filesystem::path& path);

} // namespace espalier
