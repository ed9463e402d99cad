// The journal of a project: writing it, and reading it whatever has become of it.
#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/project/corrections.h"
#include "core/project/node_bytes.h"
#include "core/project/project.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// @return the bytes that it takes, of those that ids may follow from
std::size_t insertStep(const Database& database, std::size_t step, const HistoryStep& content) {
  const std::string delta = bytesOf(content.delta, content.points, content.organs);
  Statement row = database.prepare("INSERT INTO journal VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  row.bind(1, static_cast<std::int64_t>(step))
      .bind(2, content.time)
      .bindText(3, content.author)
      .bindText(4, content.text)
      .bindBytes(5, delta)
      .bind(6, std::bit_cast<std::int64_t>(content.id))
      .bind(7, std::int64_t{content.replacesContracted});
  if (content.envelope)
    row.bindText(8, content.envelope->before).bindText(9, content.envelope->after);
  row.run();
  return delta.size();
}

void insertSnapshot(const Database& database, std::size_t step, const Skeleton& skeleton,
                    const PointSet& leftOut, const OrganMarks& organs) {
  const std::string nodes = bytesOf(skeleton, leftOut, organs);
  database.prepare("INSERT OR REPLACE INTO snapshot VALUES (?, ?)")
      .bind(1, static_cast<std::int64_t>(step))
      .bindBytes(2, nodes)
      .run();
}

/// One more than the highest id that a delta names.
std::size_t idEndIn(const SkeletonDelta& delta) {
  std::size_t end = 0;
  for (const SkeletonDelta::Change& change : delta.changes)
    end = std::max(end, indexOf(change.id) + 1);
  return end;
}

void setPosition(const Database& database, std::size_t position) {
  database.prepare("INSERT OR REPLACE INTO position VALUES (0, ?)")
      .bind(1, static_cast<std::int64_t>(position))
      .run();
}

constexpr std::int64_t mostSteps = std::int64_t{1} << 31;

/// How the step of a row changed the envelope. pre: it is a row of Journal
std::optional<EnvelopeChange> envelopeIn(const Statement& row) {
  if (row.integer(7) == 0) return std::nullopt;
  return EnvelopeChange{.before = row.text(8), .after = row.text(9)};
}

/// The rows of the journal that a condition holds for, as stepIn() reads them.
Statement journalRows(const Database& database, const std::string& condition,
                      const std::string& order) {
  return database.prepare(
      "SELECT step, time, author, text, delta, coalesce(id, step + 1), contracted, "
      "envelope_after IS NOT NULL, coalesce(envelope_before, ''), coalesce(envelope_after, '') "
      "FROM journal " +
      condition + " ORDER BY step " + order);
}

/// None: its bytes are damaged.
std::optional<HistoryStep> stepIn(const Statement& row) {
  std::optional<StoredDelta> stored = deltaFrom(row.bytes(4));
  if (!stored) return std::nullopt;
  return HistoryStep{.id = std::bit_cast<StepId>(row.integer(5)),
                     .text = row.text(3),
                     .author = row.text(2),
                     .time = row.integer(1),
                     .delta = std::move(stored->delta),
                     .points = std::move(stored->points),
                     .replacesContracted = row.integer(6) != 0,
                     .envelope = envelopeIn(row),
                     .organs = std::move(stored->organs)};
}

/// What of the journal can be read, by place. A damaged page hides what is behind it, so the other
/// end is read too.
struct Journal {
  std::map<std::int64_t, HistoryStep> steps;
  bool isDamaged = false;

  explicit Journal(const Database& database, const std::string& condition = {}) {
    read(database, condition, "ASC");
    if (isDamaged) read(database, condition, "DESC");
  }

  [[nodiscard]] std::size_t idEnd() const { return idEnd_; } // of all that steps name

  [[nodiscard]] std::int64_t end() const { return steps.empty() ? 0 : steps.rbegin()->first + 1; }

private:
  void read(const Database& database, const std::string& condition, const std::string& order) {
    try {
      Statement rows = journalRows(database, condition, order);
      while (rows.step()) {
        std::optional<HistoryStep> content = stepIn(rows);
        if (content) idEnd_ = std::max(idEnd_, idEndIn(content->delta));
        const std::int64_t step = rows.integer(0);
        if (content && step >= 0 && step < mostSteps)
          steps.insert_or_assign(step, std::move(*content));
        else
          isDamaged = true;
      }
    } catch (const DamagedFile&) {
      isDamaged = true;
    }
  }

  std::size_t idEnd_ = 0;
};

/// What idsFor() is asked about.
struct IdsAndBytes {
  std::size_t idEnd = 0;
  std::size_t bytes = 0;

  [[nodiscard]] bool isAllowed() const { return idEnd <= idsFor(bytes); }
  /// @throws ShownError with this sentence unless it is allowed
  void require(const char* refusal, const std::string& file) const {
    if (!isAllowed())
      throw ShownError({refusal, {std::to_string(idEnd), std::to_string(bytes)}, FilePlace{file}});
  }
};

/// The ids that snapshots make a table for, or `idEnd` if that is more, and the bytes of all plants
/// and edits; these are counted only where they decide.
IdsAndBytes idsAndBytes(const Database& database, std::size_t idEnd) {
  IdsAndBytes result{.idEnd = idEnd};
  std::size_t bytes = 0;
  try {
    Statement snapshots =
        database.prepare("SELECT substr(nodes, 1, 5), length(nodes) FROM snapshot");
    while (snapshots.step()) {
      result.idEnd = std::max(result.idEnd, idEndOf(snapshots.bytes(0)));
      bytes += static_cast<std::size_t>(snapshots.integer(1));
    }
    if (result.isAllowed()) return result;
    bytes += static_cast<std::size_t>(
        database.integer("SELECT coalesce(sum(length(delta)), 0) FROM journal"));
  } catch (const DamagedFile&) { // what can be read of it counts
  }
  result.bytes = bytes;
  return result;
}

/// Refuses ids that only a file has that was made to deceive: see idsFor().
/// @param idEnd  of the journal
void requireFewIds(const Database& database, std::size_t idEnd, const std::string& file) {
  idsAndBytes(database, idEnd)
      .require(espalier::Shown::tr("numbers its nodes up to %1, too far for the %2 bytes that its "
                                   "plant and edits take: open a copy, or the plant as it was "
                                   "exported"),
               file);
}

/// @throws Error if what was written would be refused when it is read
void requireAllowed(const IdsAndBytes& written, const std::string& file) {
  written.require(espalier::Shown::tr("numbers its nodes up to %1, too far for the %2 bytes that "
                                      "its plant and edits take: save the plant as an MTG, and "
                                      "begin a new project with that, which numbers its nodes "
                                      "anew"),
                  file);
}

/// Adds steps behind the first `kept`. Each beginning of the journal can be read back by itself:
/// the steps behind it may be dropped later.
void insertSteps(const Database& database, std::size_t kept, std::span<const HistoryStep> steps,
                 const std::string& file) {
  std::size_t highest = 0;
  for (const HistoryStep& step : steps)
    highest = std::max(highest, idEndIn(step.delta));
  IdsAndBytes written = idsAndBytes(database, 0);
  if (highest > idsFor(0))
    written.bytes = idsAndBytes(database, highest).bytes; // mostly they are few
  requireAllowed(written, file);
  for (const HistoryStep& step : steps) {
    written.bytes += insertStep(database, kept++, step);
    written.idEnd = std::max(written.idEnd, idEndIn(step.delta));
    requireAllowed(written, file);
  }
}

std::vector<std::int64_t> snapshotSteps(const Database& database, bool& isDamaged) {
  std::vector<std::int64_t> result;
  try {
    Statement rows = database.prepare("SELECT step FROM snapshot ORDER BY step");
    while (rows.step())
      if (rows.integer(0) >= 0 && rows.integer(0) <= mostSteps) result.push_back(rows.integer(0));
  } catch (const DamagedFile&) {
    isDamaged = true;
  }
  return result;
}

std::optional<StoredPlant> snapshotAt(const Database& database, std::int64_t step) {
  try {
    Statement row = database.prepare("SELECT nodes FROM snapshot WHERE step = ?");
    row.bind(1, step);
    if (row.step()) return plantFrom(row.bytes(0));
  } catch (const DamagedFile&) { // another snapshot may do
  }
  return std::nullopt;
}

std::optional<std::int64_t> storedPosition(const Database& database) {
  try {
    Statement row = database.prepare("SELECT step FROM position");
    if (row.step() && row.integer(0) >= 0 && row.integer(0) <= mostSteps) return row.integer(0);
  } catch (const DamagedFile&) { // the end of the journal is what was done most likely
  }
  return std::nullopt;
}

/// A place in the journal with its plant; moves while steps are there and fit.
struct Place {
  Skeleton skeleton;
  PointSet leftOut;
  OrganMarks organs;
  std::int64_t at = 0;

  void moveTowards(std::int64_t target, const Journal& journal) {
    const bool isForward = at < target;
    while (at != target) {
      const auto step = journal.steps.find(isForward ? at : at - 1);
      if (step == journal.steps.end()) return;
      const SkeletonDelta& delta = step->second.delta;
      if (!tryToApply(isForward ? delta : delta.inverse(), skeleton)) return;
      leftOut = leftOut ^ step->second.points;
      organs = organs ^ step->second.organs;
      at += isForward ? 1 : -1;
    }
  }
};

/// The place nearest to `target` that a snapshot leads to.
std::optional<Place> nearestPlace(const Database& database, const Journal& journal,
                                  std::vector<std::int64_t> snapshots, std::int64_t target) {
  std::ranges::sort(snapshots, {}, [&](std::int64_t step) { return std::abs(step - target); });
  std::optional<Place> best;
  constexpr int mostTries = 4; // one does, unless the file is damaged
  int tries = 0;
  for (const std::int64_t step : snapshots) {
    if (tries == mostTries || (best && best->at == target)) break;
    std::optional<StoredPlant> plant = snapshotAt(database, step);
    if (!plant) continue;
    ++tries;
    Place place{std::move(plant->skeleton), std::move(plant->leftOut), std::move(plant->organs),
                step};
    place.moveTowards(target, journal);
    if (!best || std::abs(place.at - target) < std::abs(best->at - target)) best = std::move(place);
  }
  return best;
}

/// @param at  the edit after which the plant is, of so many
ShownMessage damageNote(std::int64_t at, std::int64_t edits, const std::string& file) {
  return {
      espalier::Shown::tr("is damaged: the plant is as it was after %1 of %2 edits, which is all "
                          "that can be read: save it elsewhere"),
      {std::to_string(at), std::to_string(edits)},
      FilePlace{file}};
}

} // namespace

Imported<History> Project::history() const {
  const ReadTransaction one(database_);
  Journal journal(database_);
  requireFewIds(database_, journal.idEnd(), path_.string());
  const std::optional<std::int64_t> stored = storedPosition(database_);
  const std::int64_t end = journal.end();
  const std::int64_t position = std::min(stored.value_or(end), std::max(end, std::int64_t{0}));
  const std::vector<std::int64_t> snapshots = snapshotSteps(database_, journal.isDamaged);
  std::optional<Place> place = nearestPlace(database_, journal, snapshots, position);
  if (!place)
    throw DamagedFile({espalier::Shown::tr("is damaged: nothing of its plant can be read; take a "
                                           "copy if you have one"),
                       {},
                       FilePlace{path_.string()}});
  // Forth and back in place: a copy would take the memory of the plant once more.
  const std::int64_t at = place->at;
  place->moveTowards(0, journal);
  const std::int64_t first = place->at;
  place->moveTowards(end, journal);
  const std::int64_t last = place->at;
  place->moveTowards(at, journal);

  Imported<History> result;
  result.value.position = static_cast<std::size_t>(place->at - first);
  result.value.skeleton = std::move(place->skeleton);
  result.value.leftOut = std::move(place->leftOut);
  result.value.organs = std::move(place->organs);
  for (std::int64_t step = first; step < last; ++step)
    result.value.steps.push_back(std::move(journal.steps.at(step)));
  for (const HistoryStep& step : result.value.steps) // what is redone needs its ids
    for (const SkeletonDelta::Change& change : step.delta.changes)
      growIds(result.value.skeleton, indexOf(change.id) + 1);
  const bool isWhole = !journal.isDamaged && stored == place->at && first == 0 && last == end;
  if (!isWhole)
    result.notes.push_back(
        damageNote(place->at, std::max(end, stored.value_or(0)), path_.string()));
  return result;
}

namespace {

/// The plant at the stored position; none: not even that can be read as it should be.
std::optional<Place> presentPlace(const Database& database, const std::string& file) {
  const std::optional<std::int64_t> stored = storedPosition(database);
  bool isDamaged = false;
  const std::vector<std::int64_t> snapshots = snapshotSteps(database, isDamaged);
  if (!stored || isDamaged || snapshots.empty()) return std::nullopt;
  const std::int64_t nearest = *std::ranges::min_element(
      snapshots, {}, [&](std::int64_t step) { return std::abs(step - *stored); });
  const auto [first, last] = std::minmax(nearest, *stored);
  const Journal between(database, "WHERE step >= " + std::to_string(first) + " AND step < " +
                                      std::to_string(last));
  requireFewIds(database, between.idEnd(), file);
  std::optional<Place> place = nearestPlace(database, between, {nearest}, *stored);
  return place && place->at == *stored ? std::move(place) : std::nullopt;
}

/// Steps before `position`, back to the last one that made the plant anew; none: one is damaged.
std::optional<std::vector<HistoryStep>> lastSteps(const Database& database, std::int64_t position,
                                                  std::size_t size) {
  std::vector<HistoryStep> steps;
  try {
    Statement rows = journalRows(database, "WHERE step < " + std::to_string(position), "DESC");
    for (std::int64_t at = position; at > 0; --at) {
      if (!rows.step() || rows.integer(0) != at - 1) return std::nullopt;
      std::optional<HistoryStep> step = stepIn(rows);
      if (!step) return std::nullopt;
      steps.push_back(std::move(*step));
      if (madePlantAnew(steps.back(), size)) break;
      for (const SkeletonDelta::Change& change : steps.back().delta.changes) {
        if (!change.before) --size;
        if (!change.after) ++size;
      }
    }
  } catch (const DamagedFile&) {
    return std::nullopt;
  }
  std::ranges::reverse(steps);
  return steps;
}

} // namespace

Imported<History> Project::lastWork() const {
  const ReadTransaction one(database_);
  std::optional<Place> place = presentPlace(database_, path_.string());
  std::optional<std::vector<HistoryStep>> steps;
  if (place) steps = lastSteps(database_, place->at, place->skeleton.size());
  if (!steps) return history();
  const std::size_t position = steps->size();
  return {.value = {.skeleton = std::move(place->skeleton),
                    .leftOut = std::move(place->leftOut),
                    .steps = std::move(*steps),
                    .position = position,
                    .organs = std::move(place->organs)},
          .notes = {}};
}

void Project::record(std::size_t kept, std::span<const HistoryStep> added, std::size_t position,
                     const std::optional<GrownReference>& grown) {
  assert(position <= kept + added.size());
  requireSameFile();
  const auto end = static_cast<std::int64_t>(kept);
  Transaction transaction(database_);
  database_.prepare("DELETE FROM journal WHERE step >= ?").bind(1, end).run();
  database_.prepare("DELETE FROM snapshot WHERE step > ?").bind(1, end).run();
  if (grown) growScan(*grown);
  insertSteps(database_, kept, added, path_.string());
  setPosition(database_, position);
  transaction.commit();
}

void Project::insertHistory(const Database& database, const History& history,
                            const std::string& file) {
  const History beginning = beginningOf(history);
  insertSnapshot(database, 0, beginning.skeleton, beginning.leftOut, beginning.organs);
  insertSteps(database, 0, history.steps, file);
  if (history.position > 0)
    insertSnapshot(database, history.position, history.skeleton, history.leftOut, history.organs);
  setPosition(database, history.position);
}

void Project::growScan(const GrownReference& grown) const {
  assert(grown.scan.isByFile);
  insertScan(grown.scan);
  database_.prepare("DELETE FROM piece WHERE name = ?").bindText(1, keptCloudName).run();
  bool isDamaged = false;
  for (const std::int64_t step : snapshotSteps(database_, isDamaged))
    if (const std::optional<StoredPlant> plant = snapshotAt(database_, step))
      insertSnapshot(database_, static_cast<std::size_t>(step), plant->skeleton,
                     plant->leftOut | grown.added, plant->organs);
}

void Project::addVersion(const PlantVersion& version) {
  requireSameFile();
  const std::string nodes = bytesOf(version.skeleton);
  Transaction transaction(database_);
  Statement same = database_.prepare("SELECT time FROM version WHERE name = ?");
  same.bindText(1, version.name);
  if (same.step())
    throw ShownError({Shown::tr("there is a version %1 already: choose another name"),
                      {inQuotes(version.name)}});
  database_.prepare("INSERT INTO version VALUES (?, ?, ?, ?)")
      .bindText(1, version.name)
      .bind(2, version.time)
      .bindText(3, version.author)
      .bindBytes(4, nodes)
      .run();
  transaction.commit();
}

void Project::removeVersion(std::string_view name) {
  requireSameFile();
  database_.prepare("DELETE FROM version WHERE name = ?").bindText(1, name).run();
}

Imported<std::vector<PlantVersion>> Project::versions() const {
  const ReadTransaction one(database_);
  Imported<std::vector<PlantVersion>> result;
  const bool isOlder =
      database_.integer("SELECT count(*) FROM sqlite_schema WHERE name = 'version'") == 0;
  if (isOlder) return result;
  const auto note = [&](const char* sentence, std::vector<std::string> values = {}) {
    result.notes.push_back({sentence, std::move(values), FilePlace{path_.string()}});
  };
  try {
    const std::size_t all = idsAndBytes(database_, mostIds).bytes;
    Statement rows =
        database_.prepare("SELECT name, time, author, nodes FROM version ORDER BY time, name");
    while (rows.step()) {
      const std::string_view nodes = rows.bytes(3);
      std::optional<StoredPlant> plant;
      if (idEndOf(nodes) <= idsFor(all + nodes.size())) plant = plantFrom(nodes);
      if (plant)
        result.value.push_back({.name = rows.text(0),
                                .author = rows.text(2),
                                .time = rows.integer(1),
                                .skeleton = std::move(plant->skeleton)});
      else
        note(espalier::Shown::tr("its version %1 is damaged: the others can be read"),
             {inQuotes(rows.text(0))});
    }
  } catch (const DamagedFile&) {
    note(espalier::Shown::tr("some of its versions are damaged: the others can be read"));
  }
  return result;
}

bool Project::needsSnapshot() const {
  return database_.integer("SELECT coalesce(sum(length(delta)), 0) >"
                           "  (SELECT length(nodes) FROM snapshot ORDER BY step DESC LIMIT 1) "
                           "FROM journal WHERE step >= (SELECT max(step) FROM snapshot)") != 0;
}

void Project::takeSnapshot(const Skeleton& skeleton, const PointSet& leftOut,
                           const OrganMarks& organs) {
  requireSameFile();
  Transaction transaction(database_);
  const std::int64_t position = database_.integer("SELECT step FROM position");
  insertSnapshot(database_, static_cast<std::size_t>(position), skeleton, leftOut, organs);
  requireAllowed(idsAndBytes(database_, 0), path_.string());
  transaction.commit();
}

} // namespace espalier
