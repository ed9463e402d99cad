#include "core/io/atomic_file.h"

#include "core/base/shown_message.h"

#include <climits>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <fcntl.h>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace espalier {
namespace {

namespace fs = std::filesystem;

/// What to say of a file that cannot be written, and what to try.
const char* sentenceOn(int code) {
  switch (code) {
  case ENOSPC:
  case EDQUOT:
    return Shown::tr("cannot be written: %1; free some room or choose another disk");
  case EACCES:
  case EPERM:
  case EROFS:
    return Shown::tr("cannot be written: %1; choose another name, or a folder you may write to");
  case ENOENT:
  case ENOTDIR:
    return Shown::tr("cannot be written: %1; create the folder first or choose another");
  case EISDIR:
    return Shown::tr("cannot be written: %1; choose a file name");
  case ENAMETOOLONG:
    return Shown::tr("cannot be written: %1; choose a shorter name");
  default:
    return Shown::tr("cannot be written: %1; try another place");
  }
}

[[noreturn]] void fail(const fs::path& path, int code) {
  throw ShownError(
      {sentenceOn(code), {std::generic_category().message(code)}, FilePlace{path.string()}});
}

/// An open file that is written to through a stream. Failures are thrown as Error.
class FileBuffer : public std::streambuf {
public:
  /// @param name  of the file in messages
  /// @param toDisk  what is written is on the disk once it is finished
  FileBuffer(int descriptor, fs::path name, bool toDisk)
      : descriptor_(descriptor), name_(std::move(name)), toDisk_(toDisk),
        buffer_(std::size_t{1} << 18) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }
  ~FileBuffer() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FileBuffer(const FileBuffer&) = delete;
  FileBuffer& operator=(const FileBuffer&) = delete;

  void finish() {
    sync();
    if (toDisk_ && ::fsync(descriptor_) != 0) fail(name_, errno);
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
      written_ += std::max<ssize_t>(written, 0);
    }
    if (toDisk_) keepUp();
    return 0;
  }

private:
  /// The disk begins with what was written, and is waited for while it is far behind: nothing can
  /// stop the wait in the end. Where it cannot be asked to, the end takes longer.
  void keepUp() {
    constexpr off_t piece = off_t{4} << 20;
    if (written_ - begun_ < piece) return;
    (void)::sync_file_range(descriptor_, begun_, written_ - begun_, SYNC_FILE_RANGE_WRITE);
    const unsigned wait =
        SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER;
    if (begun_ > awaited_) (void)::sync_file_range(descriptor_, awaited_, begun_ - awaited_, wait);
    awaited_ = begun_;
    begun_ = written_;
  }

  int descriptor_;
  fs::path name_;
  bool toDisk_;
  off_t written_ = 0; // bytes
  off_t begun_ = 0;   // of these, the disk is at
  off_t awaited_ = 0; // of these, it has
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

/// The number of the descriptor that a path names, as /dev/stdout or /dev/fd/3; none for a file.
/// What it leads to is written on where it stands: it may be a file that others write to, too.
std::optional<int> descriptorNamed(const fs::path& path) {
  const std::string name = path.string();
  if (name == "/dev/stdout") return STDOUT_FILENO;
  if (name == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!name.starts_with(folder)) continue;
    int number = -1;
    const char* end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + folder.size(), end, number);
    if (stop == end && error == std::errc{} && number >= 0) return number;
  }
  return std::nullopt;
}

/// A pipe or device: what exists and is neither a file nor a folder.
bool isDevice(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// An open descriptor to a stream. pre: isStream(path)
int openStream(const fs::path& path) {
  const std::optional<int> named = descriptorNamed(path);
  const int descriptor =
      named ? ::fcntl(*named, F_DUPFD_CLOEXEC, 0) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(path, errno);
  return descriptor;
}

/// This computer in the name of a file: a process number means nothing on another.
std::string hostMark() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "host";
  std::string mark(name.data());
  constexpr std::size_t longest = 40;
  mark.resize(std::min(mark.size(), longest));
  for (char& c : mark)
    if (c == '/' || c == '.' || c == '-' || static_cast<unsigned char>(c) <= ' ') c = '_';
  return mark;
}

constexpr std::string_view temporaryEnd = ".tmp";

/// ".oak.mtg.HOST-PROCESS-NUMBER.tmp"; of a long name the beginning alone.
std::string temporaryName(const std::string& of, pid_t process, int number) {
  constexpr std::size_t longest = 160; // bytes, of 255 that a name may have
  return '.' + of.substr(0, longest) + '.' + hostMark() + '-' + std::to_string(process) + '-' +
         std::to_string(number) + std::string(temporaryEnd);
}

/// The process that made a temporary file of this name on this computer; none for any other file.
std::optional<pid_t> makerOf(std::string_view name) {
  if (!name.starts_with('.') || !name.ends_with(temporaryEnd)) return std::nullopt;
  name.remove_suffix(temporaryEnd.size());
  std::array<int, 2> numbers{}; // the last one first
  for (int& number : numbers) {
    const std::size_t dash = name.rfind('-');
    if (dash == std::string_view::npos) return std::nullopt;
    const char* end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + dash + 1, end, number);
    if (stop != end || error != std::errc{} || number < 0) return std::nullopt;
    name = name.substr(0, dash);
  }
  return numbers[1] > 0 && name.ends_with('.' + hostMark()) ? std::optional(numbers[1])
                                                            : std::nullopt;
}

/// Whether nobody holds a file: whoever writes one has it locked, also in another container.
bool isReleased(const fs::path& file) {
  struct stat status {};
  if (::lstat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
  if (status.st_uid != ::geteuid()) return false;
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool isFree = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  return isFree;
}

/// Puts on the disk that a file of this folder has a new name. Some file systems cannot: then the
/// order in which they write must do.
void syncFolder(const fs::path& folder) {
  const int descriptor =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

/// A file that is write-protected is kept, though it could be replaced.
void requireReplaceable(const fs::path& file, const fs::path& path) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return;
  if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
  if (::access(file.c_str(), W_OK) != 0) fail(path, errno);
}

void writeThrough(FileBuffer& buffer, const std::function<void(std::ostream&)>& write) {
  std::ostream out(&buffer);
  out.exceptions(std::ios::badbit); // passes on what the buffer throws
  write(out);
  buffer.finish();
}

} // namespace

/// A temporary file beside the one it will replace; removed unless it did.
class StagedFile::Temporary {
public:
  explicit Temporary(const fs::path& path) {
    constexpr int mostTries = 10000;
    for (int i = 0; i < mostTries && descriptor_ < 0; ++i) {
      path_ = path;
      path_.replace_filename(temporaryName(path.filename().string(), ::getpid(), i));
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) fail(path, errno);
    }
    if (descriptor_ < 0) fail(path, EEXIST);
    (void)::flock(descriptor_, LOCK_EX | LOCK_NB); // see isReleased
  }
  ~Temporary() {
    if (!path_.empty()) ::unlink(path_.c_str());
    ::close(descriptor_);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }
  /// Another descriptor, to be closed once it is written: it stays locked until it has its place.
  [[nodiscard]] int descriptor() const { return ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0); }

  void replace(const fs::path& path) {
    if (::rename(path_.c_str(), path.c_str()) != 0) fail(path, errno);
    path_.clear();
  }

private:
  fs::path path_;
  int descriptor_ = -1;
};

StagedFile::StagedFile(const fs::path& path, const std::function<void(std::ostream&)>& write)
    : path_(target(path)) {
  struct stat old {};
  const bool exists = ::stat(path_.c_str(), &old) == 0;
  requireReplaceable(path_, path);
  temporary_ = std::make_unique<Temporary>(path_);
  FileBuffer buffer(temporary_->descriptor(), path, true);
  constexpr mode_t permissionBits = 07777;
  if (exists) buffer.setPermissions(old.st_mode & permissionBits);
  writeThrough(buffer, write);
}

StagedFile::~StagedFile() = default;
StagedFile::StagedFile(StagedFile&&) noexcept = default;
StagedFile& StagedFile::operator=(StagedFile&&) noexcept = default;

const fs::path& StagedFile::written() const {
  return temporary_->path();
}

void StagedFile::show() {
  temporary_->replace(path_);
  temporary_.reset();
  syncFolder(path_.parent_path());
}

void writeAtomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  if (isStream(path)) {
    FileBuffer buffer(openStream(path), path, false);
    return writeThrough(buffer, write);
  }
  StagedFile(path, write).show();
}

void requireWritable(const fs::path& path) {
  if (isStream(path)) {
    if (::access(path.c_str(), W_OK) != 0) fail(path, errno);
    return;
  }
  const fs::path file = target(path);
  requireReplaceable(file, path);
  if (file.filename().string().size() > NAME_MAX) fail(path, ENAMETOOLONG);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) fail(path, errno);
  if (!S_ISDIR(status.st_mode)) fail(path, ENOTDIR);
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(path, errno);
}

bool isStream(const fs::path& path) {
  return descriptorNamed(path).has_value() || isDevice(path);
}

fs::path placeOf(const fs::path& path) {
  std::error_code failed;
  // Made absolute first: of a name alone that is not there yet, nothing would be.
  const fs::path place = fs::weakly_canonical(fs::absolute(target(path), failed), failed);
  return failed ? fs::absolute(path).lexically_normal() : place;
}

void removeLeftovers(const fs::path& folder) {
  std::error_code failed;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, failed), end;
       !failed && entry != end; entry.increment(failed)) {
    const std::optional<pid_t> maker = makerOf(entry->path().filename().string());
    const bool hasEnded = maker && ::kill(*maker, 0) != 0 && errno == ESRCH;
    if (hasEnded && isReleased(entry->path())) ::unlink(entry->path().c_str());
  }
}

} // namespace espalier
