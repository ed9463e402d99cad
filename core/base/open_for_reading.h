#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace espalier {

/// Files that a user names are asked for here, so that one that is missing, a folder, a pipe or
/// device, or not to be read is reported in the same words everywhere. Opens nothing: to open a
/// pipe that nobody writes to would wait for ever.
/// @throws Error which file, why it cannot be read, and what to try
void requireReadable(const std::filesystem::path& path);

/// The bytes of a file. @throws Error as requireReadable
[[nodiscard]] std::ifstream openForReading(const std::filesystem::path& path);

/// All of a short text, which may also come through a pipe, as of /dev/stdin, or be typed.
/// @throws Error as requireReadable; also of a pipe that nobody writes to, and of over 256 MiB
[[nodiscard]] std::string readText(const std::filesystem::path& path);

} // namespace espalier
