#include "core/project/database.h"

#include <sqlite3.h>

#include <utility>

namespace espalier {
namespace {

/// What to try, and with %1 what SQLite says.
const char* adviceFor(int code) {
  switch (code & 0xFF) {
  case SQLITE_FULL:
    return espalier::Shown::tr("the disk is full: free some room, or save elsewhere (%1)");
  case SQLITE_READONLY:
  case SQLITE_PERM:
    return espalier::Shown::tr(
        "it may only be read: allow writing to it and its folder, or save elsewhere (%1)");
  case SQLITE_CANTOPEN:
    return espalier::Shown::tr(
        "it cannot be opened: check that its folder exists and may be written to (%1)");
  case SQLITE_BUSY:
  case SQLITE_LOCKED:
    return espalier::Shown::tr(
        "another program is writing to it: close that, or save elsewhere (%1)");
  case SQLITE_IOERR:
    return espalier::Shown::tr(
        "the disk does not do what it is asked: check it, or save elsewhere (%1)");
  case SQLITE_TOOBIG:
    return espalier::Shown::tr("something in it is too big to be kept (%1)");
  case SQLITE_NOMEM:
    return espalier::Shown::tr("there is not enough memory: close other programs (%1)");
  default:
    return espalier::Shown::tr("this should not happen: save elsewhere, and report it (%1)");
  }
}

[[noreturn]] void fail(sqlite3* database, const std::string& file, int code) {
  const std::string detail = database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code);
  switch (code & 0xFF) {
  case SQLITE_NOTADB:
    throw DamagedFile({espalier::Shown::tr("is no project of Espalier: choose another file"),
                       {},
                       FilePlace{file}});
  case SQLITE_CORRUPT:
    throw DamagedFile({espalier::Shown::tr("is damaged (%1): take a copy of it if you have one"),
                       {detail},
                       FilePlace{file}});
  default:
    throw ShownError({adviceFor(code), {detail}, FilePlace{file}});
  }
}

/// A path as SQLite's URIs want it.
std::string uriOf(const std::filesystem::path& path) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    constexpr const char* digits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    if (c == '%' || c == '?' || c == '#') {
      uri += '%';
      uri += digits[byte >> 4];
      uri += digits[byte & 0xF];
    } else {
      uri += c;
    }
  }
  return uri;
}

int flagsOf(Opening opening) {
  constexpr int always = SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
  switch (opening) {
  case Opening::frozen:
  case Opening::readOnly:
    return always | SQLITE_OPEN_READONLY;
  case Opening::readWrite:
    return always | SQLITE_OPEN_READWRITE;
  case Opening::created:
    return always | SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  }
  return always;
}

} // namespace

Statement::Statement(sqlite3* database, std::string file, std::string_view sql)
    : statement_(nullptr, &sqlite3_finalize), file_(std::move(file)) {
  sqlite3_stmt* made = nullptr;
  const int code =
      sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &made, nullptr);
  statement_.reset(made);
  if (code != SQLITE_OK) fail(database, file_, code);
}

Statement& Statement::bind(int parameter, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), parameter, value));
  return *this;
}

Statement& Statement::bind(int parameter, double value) {
  check(sqlite3_bind_double(statement_.get(), parameter, value));
  return *this;
}

Statement& Statement::bindText(int parameter, std::string_view text) {
  check(sqlite3_bind_text64(statement_.get(), parameter, text.data(), text.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8)); // NOLINT: a cast of the library
  return *this;
}

Statement& Statement::bindBytes(int parameter, std::string_view bytes) {
  check(
      sqlite3_bind_blob64(statement_.get(), parameter, bytes.data(), bytes.size(), SQLITE_STATIC));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) check(code);
  sqlite3_reset(statement_.get());
  return false;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  return std::string(bytes(column));
}

std::string_view Statement::bytes(int column) const {
  const void* data = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  if (data == nullptr) return {};
  return {static_cast<const char*>(data), static_cast<std::size_t>(size)};
}

void Statement::check(int code) const {
  if (code == SQLITE_OK) return;
  sqlite3* database = sqlite3_db_handle(statement_.get());
  const int extended = sqlite3_extended_errcode(database);
  fail(database, file_, extended == SQLITE_OK ? code : extended);
}

Database::Database(const std::filesystem::path& path, Opening opening) : file_(path.string()) {
  const std::string uri = uriOf(path) + (opening == Opening::frozen ? "?immutable=1" : "");
  sqlite3* made = nullptr;
  const int code = sqlite3_open_v2(uri.c_str(), &made, flagsOf(opening), nullptr);
  connection_ = {made, &sqlite3_close};
  if (code != SQLITE_OK) fail(made, file_, code);
  configure();
}

Database Database::inMemory() {
  Database result;
  result.file_ = "a project";
  sqlite3* made = nullptr;
  const int code = sqlite3_open(":memory:", &made);
  result.connection_ = {made, &sqlite3_close};
  if (code != SQLITE_OK) fail(made, result.file_, code);
  return result;
}

Database Database::copy() const {
  Database result;
  result.file_ = file_;
  sqlite3* made = nullptr;
  int code = sqlite3_open_v2("", &made, flagsOf(Opening::created), nullptr);
  result.connection_ = {made, &sqlite3_close};
  if (code != SQLITE_OK) fail(made, file_, code);
  sqlite3_backup* backup = sqlite3_backup_init(made, "main", connection_.get(), "main");
  if (backup == nullptr) fail(made, file_, sqlite3_extended_errcode(made));
  (void)sqlite3_backup_step(backup, -1); // all pages; what is wrong is said at the end
  code = sqlite3_backup_finish(backup);
  if (code != SQLITE_OK) fail(made, file_, code);
  result.configure();
  return result;
}

Statement Database::prepare(std::string_view sql) const {
  return {connection_.get(), file_, sql};
}

void Database::execute(std::string_view sql) const {
  prepare(sql).run();
}

std::int64_t Database::integer(std::string_view sql) const {
  Statement statement = prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

bool Database::isInTransaction() const {
  return sqlite3_get_autocommit(connection_.get()) == 0;
}

void Database::configure() const {
  sqlite3* database = connection_.get();
  // A file of others may hold any schema: it must not run code of its own.
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  constexpr int patience = 2000; // [ms], for a backup program that holds the file for a moment
  sqlite3_busy_timeout(database, patience);
  execute("PRAGMA cell_size_check = ON");
  (void)integer("SELECT count(*) FROM sqlite_schema"); // the first look at the file
}

ReadTransaction::ReadTransaction(const Database& database)
    : database_(database.isInTransaction() ? nullptr : &database) {
  if (database_ != nullptr) database_->execute("BEGIN");
}

ReadTransaction::~ReadTransaction() {
  if (database_ == nullptr) return;
  try {
    database_->execute("ROLLBACK"); // there is nothing to commit
  } catch (const Error&) {          // SQLite has done it already
  }
}

Transaction::Transaction(const Database& database) : database_(database) {
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!isOpen_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const Error&) { // SQLite has done it already, as when the disk is full
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  isOpen_ = false;
}

} // namespace espalier
