#include "core/project/project_schema.h"

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

namespace espalier {
namespace {

/// What leads from a version to the next.
struct Upgrade {
  std::vector<const char*> tables;
  std::vector<const char*> rows = {};
};

/// Never change an entry that was released: add one.
const std::vector<Upgrade>& upgrades() {
  static const std::vector<Upgrade> all = {
      {// 0 to 1
       {"CREATE TABLE snapshot (step INTEGER PRIMARY KEY, nodes BLOB NOT NULL)",
        "CREATE TABLE journal (step INTEGER PRIMARY KEY, time INTEGER NOT NULL,"
        " author TEXT NOT NULL, text TEXT NOT NULL, delta BLOB NOT NULL)",
        "CREATE TABLE position (id INTEGER PRIMARY KEY, step INTEGER NOT NULL)",
        "CREATE TABLE document (name TEXT PRIMARY KEY, text TEXT NOT NULL) WITHOUT ROWID",
        "CREATE TABLE piece (name TEXT NOT NULL, part INTEGER NOT NULL, hash INTEGER NOT NULL,"
        " bytes BLOB NOT NULL, PRIMARY KEY (name, part))",
        "CREATE TABLE scan (id INTEGER PRIMARY KEY, absolute TEXT NOT NULL, relative TEXT NOT NULL,"
        " size INTEGER NOT NULL, hash INTEGER NOT NULL, x0 REAL, y0 REAL, z0 REAL,"
        " x1 REAL, y1 REAL, z1 REAL)"}},
      {}, // 1 to 2: nodes may carry review marks (node_bytes.h); the tables are the same
      {}, // 2 to 3: steps and snapshots may carry points that are set aside; likewise
      // 3 to 4: steps have ids. Those without one, of older projects, are numbered from 1 on. What
      // named a step by its place, or by its time, names it by its id.
      {{"ALTER TABLE journal ADD COLUMN id INTEGER",
        "ALTER TABLE journal ADD COLUMN contracted INTEGER NOT NULL DEFAULT 0"},
       {"UPDATE journal SET contracted = 1 WHERE step ="
        " (SELECT CAST(text AS INTEGER) FROM document WHERE name = 'contracted_step')",
        "UPDATE document SET name = 'contracted_by', text = CAST(text AS INTEGER) + 1"
        " WHERE name = 'contracted_step'",
        "UPDATE document SET text = coalesce((SELECT min(step) + 1 FROM journal"
        " WHERE time = CAST(document.text AS INTEGER)), 0) || substr(text, instr(text, ' '))"
        " WHERE name = 'made_with'"}},
      // 4 to 5: the columns of a scan may be its points in the order of the file
      {{"ALTER TABLE scan ADD COLUMN by_file INTEGER NOT NULL DEFAULT 0"}},
      // 5 to 6: steps may change the crown envelope
      {{"ALTER TABLE journal ADD COLUMN envelope_before TEXT",
        "ALTER TABLE journal ADD COLUMN envelope_after TEXT"}},
      {}, // 6 to 7: steps and snapshots may carry organs that were set by hand (node_bytes.h)
      // 7 to 8: states of the skeleton that were named
      {{"CREATE TABLE version (name TEXT PRIMARY KEY, time INTEGER NOT NULL, author TEXT NOT NULL,"
        " nodes BLOB NOT NULL)"}},
  };
  return all;
}

enum class Content : std::uint8_t { tablesAndRows, tables };

void upgrade(const Database& database, Content content) {
  const auto from = static_cast<int>(database.integer("PRAGMA user_version"));
  Transaction transaction(database);
  for (int version = from; version < currentSchema(); ++version) {
    const Upgrade& next = upgrades()[static_cast<std::size_t>(version)];
    for (const char* statement : next.tables)
      database.execute(statement);
    if (content == Content::tablesAndRows)
      for (const char* statement : next.rows)
        database.execute(statement);
  }
  database.execute("PRAGMA application_id = " + std::to_string(applicationId));
  database.execute("PRAGMA user_version = " + std::to_string(currentSchema()));
  transaction.commit();
}

using Tables = std::set<std::tuple<std::string, std::string, std::string>>;

Tables tablesOf(const Database& database) {
  Tables tables;
  Statement rows = database.prepare("SELECT type, name, coalesce(sql, '') FROM sqlite_schema");
  while (rows.step())
    tables.emplace(rows.text(0), rows.text(1), rows.text(2));
  return tables;
}

Tables tablesOfVersion(int version) {
  const Database database = Database::inMemory();
  for (int i = 0; i < version; ++i)
    for (const char* statement : upgrades()[static_cast<std::size_t>(i)].tables)
      database.execute(statement);
  return tablesOf(database);
}

} // namespace

int currentSchema() {
  return static_cast<int>(upgrades().size());
}

void upgradeSchema(const Database& database) {
  try {
    upgrade(database, Content::tablesAndRows);
  } catch (const DamagedFile&) { // without what is damaged, the plant may still be read
    upgrade(database, Content::tables);
  }
}

int checkedSchema(const Database& database, const std::string& file) {
  if (database.integer("PRAGMA application_id") != applicationId)
    throw DamagedFile({espalier::Shown::tr("is no project of Espalier: choose another file"),
                       {},
                       FilePlace{file}});
  const std::int64_t version = database.integer("PRAGMA user_version");
  if (version > currentSchema())
    throw ShownError({espalier::Shown::tr("was written by a newer Espalier (schema %1, this "
                                          "program knows %2): open it with that one"),
                      {std::to_string(version), std::to_string(currentSchema())},
                      FilePlace{file}});
  // Tables are compared to the letter: a file that was made to deceive gets no view or trigger in.
  if (version < 1 || tablesOf(database) != tablesOfVersion(static_cast<int>(version)))
    throw DamagedFile(
        {espalier::Shown::tr("its tables are not those of a project: choose another file"),
         {},
         FilePlace{file}});
  return static_cast<int>(version);
}

} // namespace espalier
