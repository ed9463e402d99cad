#include "core/base/open_for_reading.h"

#include "core/base/error.h"

#include <cerrno>
#include <string>
#include <system_error>
#include <unistd.h>

namespace espalier {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw Error(path.string() + ": " + why);
}

[[noreturn]] void fail(const std::filesystem::path& path, int code) {
  switch (code) {
  case ENOENT:
  case ENOTDIR:
    fail(path, "there is no such file: check its name and folder");
  case EACCES:
  case EPERM:
    fail(path, "may not be read: change its rights, or choose another file");
  default:
    fail(path, "cannot be read: " + std::generic_category().message(code) + "; try a copy of it");
  }
}

} // namespace

void requireReadable(const std::filesystem::path& path) {
  std::error_code isMissing;
  if (std::filesystem::is_directory(path, isMissing))
    fail(path, "is a folder, choose a file in it");
  if (::access(path.c_str(), R_OK) != 0) fail(path, errno);
}

std::ifstream openForReading(const std::filesystem::path& path) {
  requireReadable(path);
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, errno != 0 ? errno : EIO);
  return in;
}

} // namespace espalier
