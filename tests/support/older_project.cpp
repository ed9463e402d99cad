#include "tests/support/older_project.h"

#include "core/project/database.h"
#include "core/project/project_schema.h"

#include <string>

namespace espalier::test {

void writeAsVersion01(const std::filesystem::path& project, const std::filesystem::path& older) {
  const Database database(older, Opening::created);
  database.execute("PRAGMA journal_mode = WAL");
  database.execute("ATTACH '" + project.string() + "' AS today");
  for (const char* statement :
       {// The tables, to the letter.
        "CREATE TABLE snapshot (step INTEGER PRIMARY KEY, nodes BLOB NOT NULL)",
        "CREATE TABLE journal (step INTEGER PRIMARY KEY, time INTEGER NOT NULL,"
        " author TEXT NOT NULL, text TEXT NOT NULL, delta BLOB NOT NULL)",
        "CREATE TABLE position (id INTEGER PRIMARY KEY, step INTEGER NOT NULL)",
        "CREATE TABLE document (name TEXT PRIMARY KEY, text TEXT NOT NULL) WITHOUT ROWID",
        "CREATE TABLE piece (name TEXT NOT NULL, part INTEGER NOT NULL, hash INTEGER NOT NULL,"
        " bytes BLOB NOT NULL, PRIMARY KEY (name, part))",
        "CREATE TABLE scan (id INTEGER PRIMARY KEY, absolute TEXT NOT NULL, relative TEXT NOT"
        " NULL, size INTEGER NOT NULL, hash INTEGER NOT NULL, x0 REAL, y0 REAL, z0 REAL,"
        " x1 REAL, y1 REAL, z1 REAL)",
        "INSERT INTO snapshot SELECT * FROM today.snapshot",
        "INSERT INTO journal SELECT step, time, author, text, delta FROM today.journal",
        "INSERT INTO position SELECT * FROM today.position",
        "INSERT INTO piece SELECT * FROM today.piece",
        "INSERT INTO scan SELECT id, absolute, relative, size, hash, x0, y0, z0, x1, y1, z1"
        " FROM today.scan",
        "INSERT INTO document SELECT * FROM today.document WHERE name <> 'contracted_by'",
        "INSERT INTO document SELECT 'contracted_step', step FROM today.journal WHERE id ="
        " (SELECT CAST(text AS INTEGER) FROM today.document WHERE name = 'contracted_by')",
        "UPDATE document SET text = (SELECT time FROM today.journal WHERE id ="
        " CAST(document.text AS INTEGER)) || substr(text, instr(text, ' '))"
        " WHERE name = 'made_with'",
        "PRAGMA user_version = 3"})
    database.execute(statement);
  database.execute("PRAGMA application_id = " + std::to_string(applicationId));
}

void writeAsSchema5(const std::filesystem::path& project) {
  const Database database(project, Opening::readWrite);
  for (const char* statement :
       {"DROP TABLE version", "ALTER TABLE journal DROP COLUMN envelope_after",
        "ALTER TABLE journal DROP COLUMN envelope_before", "PRAGMA user_version = 5"})
    database.execute(statement);
}

} // namespace espalier::test
