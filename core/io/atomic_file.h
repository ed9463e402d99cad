#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace espalier {

/// Writes a file so that it is either complete or as it was before.
///
/// `write` fills a temporary file in the same folder, which then takes the place of `path`; it is
/// on the disk when this returns. A symbolic link is followed, and the permissions of a file that
/// is replaced are kept. What is no regular file, as /dev/stdout, is written to directly.
///
/// @throws Error which file cannot be written and why; whatever `write` throws. The file of old is
///         then untouched and nothing else is left behind.
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(std::ostream&)>& write);

/// Tells before a long computation what writeAtomically would say after it: that the folder is
/// missing, that a folder has this name, or that writing there is not allowed. It writes nothing,
/// so a full disk shows only later.
/// @throws Error as writeAtomically
void requireWritable(const std::filesystem::path& path);

} // namespace espalier
