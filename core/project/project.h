#pragma once

#include "core/base/imported.h"
#include "core/project/database.h"
#include "core/project/history.h"
#include "core/project/project_lock.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

enum class Access : std::uint8_t { readOnly, readWrite };

/// Where a scan is, and how to know that it is the same.
struct ScanReference {
  std::filesystem::path path; // absolute, when it was last found
  std::uint64_t size = 0;     // bytes
  std::uint64_t hash = 0;     // contentHash of the file
  Eigen::AlignedBox3d bounds; // of its points [L], frame of the file
  /// Its columns are the points in the order of the file (sortedAsInFile): scans were joined in it.
  bool isByFile = false;

  /// Reads it all. @throws Cancelled if `progress` asks to stop
  [[nodiscard]] static ScanReference of(const std::filesystem::path& path,
                                        const Eigen::AlignedBox3d& bounds,
                                        const Progress& progress = {});
};

/// A scan that lists the points of the one before, and behind these others.
struct GrownReference {
  ScanReference scan; // isByFile
  PointSet added;     // the others
};

/// The points of the scan among the bytes of a project, if they are kept there.
inline constexpr const char* keptCloudName = "cloud";

/// A state of the skeleton that was given a name.
struct PlantVersion {
  std::string name; // no other version of the project has it
  std::string author = {};
  std::int64_t time = 0; // [ms] since 1970-01-01 UTC
  Skeleton skeleton = {};

  bool operator==(const PlantVersion&) const = default;
};

/// Whether a file begins as a project does, whatever its name.
[[nodiscard]] bool isProject(const std::filesystem::path& path);

/// A project file, "*.espalier": the plant at work, always saved.
///
/// An SQLite database in WAL mode. What record() and the setters wrote is on the disk when they
/// return, and is there after a power cut; what was not finished has not begun. Only one Project
/// at a time may write to a file. A write first checks that the file still has its name and may
/// be written to: one that was removed or replaced meanwhile is an Error, not a silent loss.
///
/// Each call but the constructors may throw an Error that says which file, what is wrong and what
/// to try; the file is then as it was before.
class Project {
public:
  /// Makes a project of `history`, in place of any file of this name once it is complete.
  /// @throws ProjectInUse if a window works on a project of this name
  [[nodiscard]] static Project create(const std::filesystem::path& path, const History& history);

  /// @throws ProjectInUse if `access` is to write and another window does
  /// @throws DamagedFile  if it is no project or cannot be read at all
  /// @throws Error        if it was written by a newer program, is missing, may not be written to
  [[nodiscard]] static Project open(const std::filesystem::path& path, Access access);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] Access access() const { return access_; }

  /// The plant and its undo history. Of a damaged file, what can be read: the state nearest to the
  /// last one that can be reached, the steps that lead from it without a gap, and a note. Do not
  /// record() in a project that was read with a note: save it elsewhere.
  /// Time O(all edits): every step is tried, so that each can be undone or redone later.
  [[nodiscard]] Imported<History> history() const;

  /// The plant as it is, and of the steps that are done those from the last one on that made it
  /// anew (madePlantAnew), or all: what handWork() counts. Of a damaged file, history().
  /// Time O(nodes + changes of these steps), however many reconstructions were before.
  [[nodiscard]] Imported<History> lastWork() const;

  /// Changes the history: its first `kept` steps stay, `added` follow, `position` are done.
  /// Time O(changes of `added`), one sync of the disk.
  /// @param grown  the scan of the project from then on, whose new points are set aside in each
  ///               state before `added`; a scan that is kept in the project is dropped. All at
  ///               once: killed in between, the project has neither the scan nor the steps
  /// pre: kept <= steps so far, position <= kept + added.size(), each step fits where it stands
  void record(std::size_t kept, std::span<const HistoryStep> added, std::size_t position,
              const std::optional<GrownReference>& grown = {});

  /// Another skeleton without a history.
  void reset(const Skeleton& skeleton);

  /// Whether the journal since the last snapshot is longer than the plant.
  [[nodiscard]] bool needsSnapshot() const;
  /// Writes the plant at the position now beside the journal: less to lose if a step is damaged.
  /// For when nobody waits.
  void takeSnapshot(const Skeleton& skeleton, const PointSet& leftOut, const OrganMarks& organs);

  /// Keeps a state of the skeleton, whatever becomes of the history.
  /// @throws Error also if there is a version of this name
  void addVersion(const PlantVersion& version);
  void removeVersion(std::string_view name); // if there is one
  /// All of them, the oldest first; of those that are damaged, a note.
  [[nodiscard]] Imported<std::vector<PlantVersion>> versions() const;

  /// Texts by name: pipeline options, view, evaluation, frame of an MTG ... Empty removes it.
  void setDocument(std::string_view name, std::string_view text);
  [[nodiscard]] std::string document(std::string_view name) const; // empty: none

  /// Bytes by name: contracted positions, states of points, an embedded scan ... Empty removes
  /// them.
  void setBytes(std::string_view name, std::string_view bytes);
  /// @throws DamagedFile if they are not as they were written
  [[nodiscard]] std::string bytes(std::string_view name) const; // empty: none
  [[nodiscard]] bool hasBytes(std::string_view name) const;
  /// One piece of bytes, of any size: see PieceWriter. They are the pieces from 0 on in order, and
  /// none while there is no piece 0.
  void setPiece(std::string_view name, std::int64_t part, std::string_view bytes);

  void setScan(const std::optional<ScanReference>& scan);
  [[nodiscard]] std::optional<ScanReference> scan() const;

  /// Where the scan is now: at its old place, as seen from the project, or in its folder under any
  /// name; none if nowhere. A file counts if its size and hash do.
  /// @throws Cancelled if `progress` asks to stop, which it is asked alone
  [[nodiscard]] std::optional<std::filesystem::path> findScan(const Progress& progress = {}) const;

  /// The same file by a connection of its own, for one other thread: both may write, each call
  /// waiting for those of the other. The right to write goes with the last of them.
  [[nodiscard]] Project another() const;

  /// Gives back the room of what is no longer used. Takes a while.
  void compact();

private:
  Project(std::filesystem::path path, Access access, std::shared_ptr<ProjectLock> lock);
  void requireSameFile() const;
  void insertScan(const ScanReference& scan) const;
  static void insertHistory(const Database& database, const History& history,
                            const std::string& file);
  void growScan(const GrownReference& grown) const; // within a transaction

  std::filesystem::path path_;
  Access access_;
  std::shared_ptr<ProjectLock> lock_; // null: read only; outlives the database
  Database database_;
  std::uint64_t device_ = 0; // of the file that is open
  std::uint64_t inode_ = 0;
};

} // namespace espalier
