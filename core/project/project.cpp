#include "core/project/project.h"

#include "core/base/open_for_reading.h"
#include "core/project/content_hash.h"
#include "core/project/node_bytes.h"
#include "core/project/project_schema.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <fstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace espalier {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t pieceSize = std::size_t{16} << 20; // SQLite keeps no blob over 1 GB

/// A journal beside the file holds edits that are not in the file itself yet.
bool hasWaitingEdits(const fs::path& path) {
  std::error_code isMissing;
  const auto size = fs::file_size(path.string() + "-wal", isMissing);
  return !isMissing && size > 0;
}

Database openedIn(const fs::path& path, Access access) {
  requireReadable(path);
  if (access == Access::readWrite) return {path, Opening::readWrite};
  const auto mayChange = [&] { return ProjectLock::holder(path) || hasWaitingEdits(path); };
  if (mayChange()) return {path, Opening::readOnly};
  Database frozen(path, Opening::frozen);
  if (mayChange()) return {path, Opening::readOnly}; // a window came meanwhile
  return frozen;
}

fs::path whole(const fs::path& path) {
  std::error_code failed;
  const fs::path result = fs::weakly_canonical(path, failed);
  return failed ? fs::absolute(path) : result;
}

/// A name beside `path` for what is not complete yet.
fs::path unfinished(const fs::path& path) {
  return path.string() + ".new-" + std::to_string(::getpid());
}

void insertPiece(const Database& database, std::string_view name, std::int64_t part,
                 std::string_view bytes) {
  database.prepare("INSERT OR REPLACE INTO piece VALUES (?, ?, ?, ?)")
      .bindText(1, name)
      .bind(2, part)
      .bind(3, std::bit_cast<std::int64_t>(contentHash(bytes)))
      .bindBytes(4, bytes)
      .run();
}

bool isTheScan(const fs::path& path, const ScanReference& scan, const Progress& progress) {
  std::error_code failed;
  if (!fs::is_regular_file(path, failed) || fs::file_size(path, failed) != scan.size) return false;
  try {
    return contentHashOfFile(path, progress) == scan.hash;
  } catch (const Error&) { // it may not be read
    return false;
  }
}

} // namespace

ScanReference ScanReference::of(const fs::path& path, const Eigen::AlignedBox3d& bounds,
                                const Progress& progress) {
  const std::uint64_t hash = contentHashOfFile(path, progress); // throws if it cannot be read
  return {.path = whole(path), .size = fs::file_size(path), .hash = hash, .bounds = bounds};
}

bool isProject(const fs::path& path) {
  constexpr std::size_t idAt = 68;
  std::array<char, idAt + 4> header{};
  std::error_code isMissing;
  if (!fs::is_regular_file(path, isMissing)) return false; // to open a pipe would wait
  std::ifstream in(path, std::ios::binary);
  in.read(header.data(), header.size());
  const std::string_view bytes(header.data(), header.size());
  return in && bytes.starts_with("SQLite format 3") && bytes.substr(idAt) == "Espl";
}

Project::Project(fs::path path, Access access, std::shared_ptr<ProjectLock> lock)
    : path_(std::move(path)), access_(access), lock_(std::move(lock)),
      database_(openedIn(path_, access)) {
  const int schema = checkedSchema(database_, path_.string());
  struct stat status {};
  if (::stat(path_.c_str(), &status) == 0) {
    device_ = status.st_dev;
    inode_ = status.st_ino;
  }
  if (access == Access::readOnly) {
    if (schema >= firstReadAsItIs) return;
    database_ = database_.copy(); // the file stays as it is
    upgradeSchema(database_);
    return;
  }
  (void)database_.integer("PRAGMA journal_mode = WAL");
  database_.execute(
      "PRAGMA synchronous = FULL"); // an edit that was reported as saved survives a power cut
  if (schema < currentSchema()) upgradeSchema(database_);
}

Project Project::create(const fs::path& path, const History& history) {
  auto lock = std::make_unique<ProjectLock>(path);
  const fs::path target = whole(path);
  const fs::path made = unfinished(target);
  try {
    fs::remove(made);
    const Database database(made, Opening::created);
    upgradeSchema(database);
    Transaction transaction(database);
    insertHistory(database, history, path.string());
    transaction.commit();
  } catch (...) {
    std::error_code ignored;
    fs::remove(made, ignored);
    throw;
  }
  for (const char* of :
       {"-wal", "-shm"}) // of a file that is replaced: not to be read into this one
    fs::remove(target.string() + of);
  std::error_code failed;
  fs::rename(made, target, failed);
  if (failed) {
    fs::remove(made);
    throw ShownError({espalier::Shown::tr("cannot be written: %1; try another place"),
                      {failed.message()},
                      FilePlace{path.string()}});
  }
  return {target, Access::readWrite, std::move(lock)};
}

Project Project::open(const fs::path& path, Access access) {
  std::unique_ptr<ProjectLock> lock;
  if (access == Access::readWrite) {
    requireReadable(path);
    if (::access(path.c_str(), W_OK) != 0)
      throw ShownError(
          {espalier::Shown::tr("may only be read: open it to read only, or open a copy"),
           {},
           FilePlace{path.string()}});
    lock = std::make_unique<ProjectLock>(path);
  }
  return {whole(path), access, std::move(lock)};
}

void Project::reset(const Skeleton& skeleton) {
  requireSameFile();
  Transaction transaction(database_);
  for (const char* table : {"snapshot", "journal", "position"})
    database_.execute(std::string("DELETE FROM ") + table);
  insertHistory(database_, {.skeleton = skeleton}, path_.string());
  transaction.commit();
}

void Project::setDocument(std::string_view name, std::string_view text) {
  requireSameFile();
  if (text.empty())
    database_.prepare("DELETE FROM document WHERE name = ?").bindText(1, name).run();
  else
    database_.prepare("INSERT OR REPLACE INTO document VALUES (?, ?)")
        .bindText(1, name)
        .bindText(2, text)
        .run();
}

std::string Project::document(std::string_view name) const {
  Statement row = database_.prepare("SELECT text FROM document WHERE name = ?");
  row.bindText(1, name);
  return row.step() ? row.text(0) : std::string();
}

void Project::setBytes(std::string_view name, std::string_view bytes) {
  requireSameFile();
  Transaction transaction(database_);
  database_.prepare("DELETE FROM piece WHERE name = ?").bindText(1, name).run();
  for (std::int64_t part = 0; !bytes.empty(); ++part) {
    const std::string_view piece = bytes.substr(0, pieceSize);
    insertPiece(database_, name, part, piece);
    bytes.remove_prefix(piece.size());
  }
  transaction.commit();
}

void Project::setPiece(std::string_view name, std::int64_t part, std::string_view bytes) {
  requireSameFile();
  insertPiece(database_, name, part, bytes);
}

bool Project::hasBytes(std::string_view name) const {
  Statement row = database_.prepare("SELECT part FROM piece WHERE name = ? AND part = 0");
  row.bindText(1, name);
  return row.step();
}

std::string Project::bytes(std::string_view name) const {
  Statement rows =
      database_.prepare("SELECT part, hash, bytes FROM piece WHERE name = ? ORDER BY part");
  rows.bindText(1, name);
  std::string result;
  for (std::int64_t part = 0; rows.step(); ++part) {
    if (part == 0 && rows.integer(0) > 0) return {}; // they were never complete
    const std::string_view piece = rows.bytes(2);
    if (rows.integer(0) != part ||
        std::bit_cast<std::uint64_t>(rows.integer(1)) != contentHash(piece))
      throw DamagedFile({espalier::Shown::tr("its \"%1\" are damaged: make them again"),
                         {std::string(name)},
                         FilePlace{path_.string()}});
    result += piece;
  }
  return result;
}

void Project::setScan(const std::optional<ScanReference>& scan) {
  requireSameFile();
  Transaction transaction(database_);
  database_.execute("DELETE FROM scan");
  if (scan) insertScan(*scan);
  transaction.commit();
}

void Project::insertScan(const ScanReference& scan) const {
  Statement row =
      database_.prepare("INSERT OR REPLACE INTO scan VALUES (0, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  row.bindText(1, scan.path.string())
      .bindText(2, scan.path.lexically_relative(path_.parent_path()).string())
      .bind(3, std::bit_cast<std::int64_t>(scan.size))
      .bind(4, std::bit_cast<std::int64_t>(scan.hash));
  for (int i = 0; i < 3; ++i)
    row.bind(5 + i, scan.bounds.min()[i]).bind(8 + i, scan.bounds.max()[i]);
  row.bind(11, std::int64_t{scan.isByFile}).run();
}

std::optional<ScanReference> Project::scan() const {
  Statement row =
      database_.prepare("SELECT absolute, size, hash, x0, y0, z0, x1, y1, z1, by_file FROM scan");
  if (!row.step()) return std::nullopt;
  ScanReference scan{.path = row.text(0),
                     .size = std::bit_cast<std::uint64_t>(row.integer(1)),
                     .hash = std::bit_cast<std::uint64_t>(row.integer(2)),
                     .bounds = {},
                     .isByFile = row.integer(9) != 0};
  for (int i = 0; i < 3; ++i) {
    scan.bounds.min()[i] = row.real(3 + i);
    scan.bounds.max()[i] = row.real(6 + i);
  }
  return scan;
}

std::optional<fs::path> Project::findScan(const Progress& progress) const {
  const std::optional<ScanReference> reference = scan();
  if (!reference) return std::nullopt;
  const fs::path folder = path_.parent_path();
  Statement row = database_.prepare("SELECT relative FROM scan");
  const fs::path relative = row.step() ? row.text(0) : std::string();
  std::vector<fs::path> places = {reference->path, folder / relative,
                                  folder / reference->path.filename()};
  std::error_code unreadable;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable))
    places.push_back(entry.path());
  const auto found = std::ranges::find_if(
      places, [&](const fs::path& place) { return isTheScan(place, *reference, progress); });
  if (found == places.end()) return std::nullopt;
  return found->lexically_normal();
}

Project Project::another() const {
  return {path_, access_, lock_};
}

void Project::compact() {
  requireSameFile();
  database_.execute("VACUUM");
  (void)database_.integer("PRAGMA wal_checkpoint(TRUNCATE)");
}

void Project::requireSameFile() const {
  const auto refuse = [&](const char* sentence) {
    throw ShownError({sentence, {}, FilePlace{path_.string()}});
  };
  if (access_ == Access::readOnly)
    refuse(espalier::Shown::tr("is open to read only: save it elsewhere to edit it"));
  struct stat status {};
  if (::stat(path_.c_str(), &status) != 0)
    refuse(espalier::Shown::tr("was removed while it was open: save it elsewhere"));
  if (status.st_ino != inode_ || status.st_dev != device_)
    refuse(espalier::Shown::tr("was replaced by another program: save it elsewhere"));
  constexpr mode_t anyMayWrite = 0222;
  if ((status.st_mode & anyMayWrite) == 0)
    refuse(espalier::Shown::tr(
        "was made read-only while it was open: allow writing to it, or save elsewhere"));
}

} // namespace espalier
