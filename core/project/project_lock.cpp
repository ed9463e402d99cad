#include "core/project/project_lock.h"

#include "core/base/text.h"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;

fs::path lockOf(const fs::path& project) {
  std::error_code isMissing;
  const fs::path whole = fs::weakly_canonical(project, isMissing); // one lock for all its names
  return (isMissing ? project : whole).string() + ".lock";
}

/// Why there is no lock beside a project that is to be opened or made.
ShownMessage notWritten(const fs::path& project, int reason) {
  std::error_code isMissing;
  const fs::path folder = project.parent_path();
  const bool isNowhere = reason == ENOENT || reason == ENOTDIR;
  if (isNowhere && !folder.empty() && !fs::is_directory(folder, isMissing))
    return {espalier::Shown::tr("there is no folder %1: make it, or choose another"),
            {inQuotes(folder.string())},
            FilePlace{project.string()}};
  return {espalier::Shown::tr("cannot be written: %1; open it to read only, or save it elsewhere"),
          {std::generic_category().message(reason)},
          FilePlace{project.string()}};
}

std::string hostName() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "this computer";
  return name.data();
}

std::string holderIn(int descriptor) {
  std::array<char, 300> text{};
  const ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
  std::string result(text.data(), static_cast<std::size_t>(size > 0 ? size : 0));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  while (result.ends_with(' '))
    result.pop_back();
  return result;
}

/// Whether the file that is open is the one that has this name: another program may have removed
/// it between our opening and our locking it.
bool isStill(int descriptor, const fs::path& path) {
  struct stat open {};
  struct stat named {};
  return ::fstat(descriptor, &open) == 0 && ::stat(path.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

} // namespace

ProjectLock::ProjectLock(const fs::path& project) : path_(lockOf(project)) {
  while (descriptor_ < 0) {
    const int descriptor = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) throw ShownError(notWritten(project, errno));
    const bool isTaken = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (isTaken) { // any other failure: a disk without locks, where nobody can be kept out
      const std::string holder = holderIn(descriptor);
      ::close(descriptor);
      throw ProjectInUse(
          {holder.empty() ? espalier::Shown::tr("is open in another window: go on there, open it "
                                                "to read only, or open a copy")
                          : espalier::Shown::tr("is open in another window (%1): go on there, open "
                                                "it to read only, or open a copy"),
           {holder},
           FilePlace{project.string()}});
    }
    if (isStill(descriptor, path_))
      descriptor_ = descriptor;
    else
      ::close(descriptor);
  }
  const std::string holder = "process " + std::to_string(::getpid()) + " on " + hostName() + "\n";
  // Only a message depends on it: a full disk does not keep anyone from opening.
  if (::ftruncate(descriptor_, 0) == 0)
    (void)!::pwrite(descriptor_, holder.data(), holder.size(), 0);
}

ProjectLock::~ProjectLock() {
  ::unlink(path_.c_str()); // while it is locked: who waits for it sees that it is gone
  ::close(descriptor_);
}

std::optional<std::string> ProjectLock::holder(const fs::path& project) {
  const int descriptor = ::open(lockOf(project).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  std::optional<std::string> result;
  if (::flock(descriptor, LOCK_SH | LOCK_NB) != 0) result = holderIn(descriptor);
  ::close(descriptor);
  return result;
}

} // namespace espalier
