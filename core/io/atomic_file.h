#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>

namespace espalier {

/// Writes a file so that it is either complete or as it was before.
///
/// `write` fills a temporary file in the same folder, which then takes the place of `path`; it is
/// on the disk when this returns. A symbolic link is followed, and the permissions of a file that
/// is replaced are kept. A stream is written to directly.
///
/// @throws Error which file cannot be written and why; whatever `write` throws. The file of old is
///         then untouched and nothing else is left behind.
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(std::ostream&)>& write);

/// The same in two steps: what is written is on the disk, and can be read, before it takes the
/// place of `path`. Removed unless it does.
class StagedFile {
public:
  /// @throws as writeAtomically. pre: !isStream(path)
  StagedFile(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
  ~StagedFile();
  StagedFile(StagedFile&&) noexcept;
  StagedFile& operator=(StagedFile&&) noexcept;

  [[nodiscard]] const std::filesystem::path& written() const; // pre: it is not shown yet
  /// @throws Error why it cannot take its place; the file of old is then untouched
  void show();

private:
  class Temporary;
  std::unique_ptr<Temporary> temporary_; // null: shown
  std::filesystem::path path_;
};

/// Reports before a long computation what writeAtomically would report after it: that the folder is
/// missing, that a folder has this name, or that writing there, or to a file that is there, is not
/// allowed. It writes nothing, so a full disk shows only later.
/// @throws Error as writeAtomically
void requireWritable(const std::filesystem::path& path);

/// Whether a path is no file that is replaced as a whole: a pipe, a device, or what a descriptor of
/// this program leads to, as /dev/stdout.
[[nodiscard]] bool isStream(const std::filesystem::path& path);

/// Where what is written to `path` arrives, through all links; two paths that lead to one file,
/// whether it exists or not, give one place.
/// @throws Error if links lead in a circle
[[nodiscard]] std::filesystem::path placeOf(const std::filesystem::path& path);

/// Removes the temporary files that writeAtomically left in a folder when it was killed: those of
/// processes that have ended, of this user and this computer. Others stay, and what cannot be
/// removed.
void removeLeftovers(const std::filesystem::path& folder);

} // namespace espalier
