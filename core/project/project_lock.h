#pragma once

#include "core/base/shown_message.h"

#include <filesystem>
#include <optional>
#include <string>

namespace espalier {

/// Another window or program works on the project. The message says which.
class ProjectInUse : public ShownError {
public:
  using ShownError::ShownError;
};

/// The right to write to a project, held by one window of one program at a time.
///
/// A file beside the project, "name.espalier.lock", names the holder. The system frees the lock
/// with the process, however that ends: a file that was left behind keeps nobody out.
class ProjectLock {
public:
  /// @throws ProjectInUse by whom
  /// @throws Error        why the folder cannot be written to
  explicit ProjectLock(const std::filesystem::path& project);
  ~ProjectLock();
  ProjectLock(const ProjectLock&) = delete;
  ProjectLock& operator=(const ProjectLock&) = delete;

  /// Who holds the lock of a project, as "process 12 on host"; none: nobody.
  [[nodiscard]] static std::optional<std::string> holder(const std::filesystem::path& project);

private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

} // namespace espalier
