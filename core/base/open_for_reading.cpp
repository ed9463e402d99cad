#include "core/base/open_for_reading.h"

#include "core/base/shown_message.h"

#include <cerrno>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace espalier {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* why,
                       std::vector<std::string> values = {}) {
  throw ShownError({why, std::move(values), FilePlace{path.string()}});
}

[[noreturn]] void fail(const std::filesystem::path& path, int code) {
  switch (code) {
  case ENOENT:
  case ENOTDIR:
    fail(path, espalier::Shown::tr("there is no such file: check its name and folder"));
  case EACCES:
  case EPERM:
    fail(path, espalier::Shown::tr("may not be read: change its rights, or choose another file"));
  default:
    fail(path, espalier::Shown::tr("cannot be read: %1; try a copy of it"),
         {std::generic_category().message(code)});
  }
}

/// What kind of file it is. @throws Error if it is missing, or a folder
mode_t kindOf(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) fail(path, errno);
  if (S_ISDIR(status.st_mode)) fail(path, espalier::Shown::tr("is a folder, choose a file in it"));
  return status.st_mode;
}

/// An open file.
class Descriptor {
public:
  explicit Descriptor(const std::filesystem::path& path)
      : number_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    if (number_ < 0) fail(path, errno);
  }
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }

private:
  int number_;
};

std::string allOf(const Descriptor& file, const std::filesystem::path& path) {
  constexpr std::size_t most = std::size_t{1} << 28;
  std::string text;
  std::vector<char> block(std::size_t{1} << 16);
  for (;;) {
    const ssize_t got = ::read(file.number(), block.data(), block.size());
    if (got == 0) return text;
    if (got < 0 && errno != EINTR) fail(path, errno);
    if (got > 0) text.append(block.data(), static_cast<std::size_t>(got));
    if (text.size() > most)
      fail(path, espalier::Shown::tr("is longer than any such text: choose another file"));
  }
}

} // namespace

void requireReadable(const std::filesystem::path& path) {
  if (!S_ISREG(kindOf(path)))
    fail(path, espalier::Shown::tr("is a pipe or device: save it as a file and open that"));
  if (::access(path.c_str(), R_OK) != 0) fail(path, errno);
}

std::ifstream openForReading(const std::filesystem::path& path) {
  requireReadable(path);
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, errno != 0 ? errno : EIO);
  return in;
}

std::string readText(const std::filesystem::path& path) {
  const mode_t kind = kindOf(path);
  if (!S_ISFIFO(kind) && !S_ISCHR(kind)) requireReadable(path);
  const Descriptor file(path);
  if (S_ISCHR(kind) && ::isatty(file.number()) == 0)
    fail(path, espalier::Shown::tr("is a device: save it as a file and open that"));
  ::fcntl(file.number(), F_SETFL, 0); // reading waits for whoever writes, and ends if nobody does
  std::string text = allOf(file, path);
  if (text.empty() && S_ISFIFO(kind))
    fail(path,
         espalier::Shown::tr("is a pipe that nobody writes to: save it as a file and open that"));
  return text;
}

} // namespace espalier
