#include "core/io/atomic_file.h"

#include "core/base/error.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace espalier {
namespace {

namespace fs = std::filesystem;

std::string adviceFor(int code) {
  switch (code) {
  case ENOSPC:
  case EDQUOT:
    return "free some room or choose another disk";
  case EACCES:
  case EPERM:
  case EROFS:
    return "choose a folder you may write to";
  case ENOENT:
  case ENOTDIR:
    return "create the folder first or choose another";
  case EISDIR:
    return "choose a file name";
  default:
    return "try another place";
  }
}

[[noreturn]] void fail(const fs::path& path, int code) {
  throw Error(path.string() + ": cannot be written: " + std::generic_category().message(code) +
              "; " + adviceFor(code));
}

/// An open file that is written to through a stream. Failures are thrown as Error.
class FileBuffer : public std::streambuf {
public:
  /// @param name  of the file in messages
  FileBuffer(int descriptor, fs::path name)
      : descriptor_(descriptor), name_(std::move(name)), buffer_(std::size_t{1} << 18) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }
  ~FileBuffer() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FileBuffer(const FileBuffer&) = delete;
  FileBuffer& operator=(const FileBuffer&) = delete;

  void finish(bool toDisk) {
    sync();
    if (toDisk && ::fsync(descriptor_) != 0) fail(name_, errno);
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(name_, errno);
  }

  void setPermissions(mode_t mode) const {
    if (::fchmod(descriptor_, mode) != 0) fail(name_, errno);
  }

protected:
  int_type overflow(int_type c) override {
    sync();
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    return sputc(traits_type::to_char_type(c));
  }

  int sync() override {
    std::string_view left(pbase(), static_cast<std::size_t>(pptr() - pbase()));
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    while (!left.empty()) {
      const ssize_t written = ::write(descriptor_, left.data(), left.size());
      if (written < 0 && errno != EINTR) fail(name_, errno);
      left.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return 0;
  }

private:
  int descriptor_;
  fs::path name_;
  std::vector<char> buffer_;
};

/// The file that `path` leads to through symbolic links, whether it exists or not.
fs::path target(const fs::path& path) {
  fs::path result = path;
  constexpr int mostLinks = 40; // as the kernel
  for (int i = 0; i < mostLinks; ++i) {
    std::error_code isNoLink;
    const fs::path next = fs::read_symlink(result, isNoLink);
    if (isNoLink) return result;
    result = result.parent_path() / next; // an absolute `next` stands alone
  }
  fail(path, ELOOP);
}

/// A temporary file beside the one it will replace; removed unless it did.
class TemporaryFile {
public:
  explicit TemporaryFile(const fs::path& path) {
    constexpr int mostTries = 10000;
    for (int i = 0; i < mostTries && descriptor_ < 0; ++i) {
      path_ = path;
      path_.replace_filename("." + path.filename().string() + "." + std::to_string(::getpid()) +
                             "-" + std::to_string(i) + ".tmp");
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) fail(path, errno);
    }
    if (descriptor_ < 0) fail(path, EEXIST);
  }
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; } // the taker closes it

  void replace(const fs::path& path) {
    if (::rename(path_.c_str(), path.c_str()) != 0) fail(path, errno);
    path_.clear();
  }

private:
  fs::path path_;
  int descriptor_ = -1;
};

/// Puts on the disk that a file of this folder has a new name. Some file systems cannot: then the
/// order in which they write must do.
void syncFolder(const fs::path& folder) {
  const int descriptor =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

void writeThrough(FileBuffer& buffer, const std::function<void(std::ostream&)>& write,
                  bool toDisk) {
  std::ostream out(&buffer);
  out.exceptions(std::ios::badbit); // passes on what the buffer throws
  write(out);
  buffer.finish(toDisk);
}

} // namespace

void writeAtomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  const fs::path file = target(path);
  struct stat old {};
  const bool exists = ::stat(file.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) fail(path, EISDIR);
  if (exists && !S_ISREG(old.st_mode)) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(path, errno);
    FileBuffer buffer(descriptor, path);
    writeThrough(buffer, write, false);
    return;
  }
  TemporaryFile temporary(file);
  FileBuffer buffer(temporary.descriptor(), path);
  constexpr mode_t permissionBits = 07777;
  if (exists) buffer.setPermissions(old.st_mode & permissionBits);
  writeThrough(buffer, write, true);
  temporary.replace(file);
  syncFolder(file.parent_path());
}

void requireWritable(const fs::path& path) {
  const fs::path file = target(path);
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
    if (::access(file.c_str(), W_OK) != 0) fail(path, errno);
    return;
  }
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (::stat(folder.c_str(), &status) != 0) fail(path, errno);
  if (!S_ISDIR(status.st_mode)) fail(path, ENOTDIR);
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(path, errno);
}

} // namespace espalier
