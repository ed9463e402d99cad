#pragma once

#include "core/base/shown_message.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace espalier {

/// How a file is opened. `frozen`: nobody writes to it meanwhile, and nothing is put beside it.
enum class Opening : std::uint8_t { frozen, readOnly, readWrite, created };

/// The file is no database, or bytes of it have changed.
class DamagedFile : public ShownError {
public:
  using ShownError::ShownError;
};

/// One statement of SQL. Columns and parameters count from 0 and 1, as SQLite's do.
class Statement {
public:
  /// @throws Error   what is wrong with the file, and what to try; so for all that follows
  Statement(sqlite3* database, std::string file, std::string_view sql);

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, double value);
  Statement& bindText(int parameter, std::string_view text);   // copied
  Statement& bindBytes(int parameter, std::string_view bytes); // must outlive the steps

  /// Runs to the next row. False: there is none.
  bool step();
  void run() { // pre: it has no rows
    while (step()) {
    }
  }

  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::string_view bytes(int column) const; // until the next step

private:
  void check(int code) const;

  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
  std::string file_;
};

/// An SQLite file, open.
class Database {
public:
  /// @throws Error why it cannot be opened
  Database(const std::filesystem::path& path, Opening opening);
  [[nodiscard]] static Database inMemory();
  /// The same content in a file that has no name and goes with the connection.
  [[nodiscard]] Database copy() const;

  [[nodiscard]] Statement prepare(std::string_view sql) const;
  void execute(std::string_view sql) const;                       // one statement
  [[nodiscard]] std::int64_t integer(std::string_view sql) const; // 0 without a row

private:
  friend class ReadTransaction;
  Database() = default;
  [[nodiscard]] bool isInTransaction() const;
  void configure() const;

  std::unique_ptr<sqlite3, int (*)(sqlite3*)> connection_{nullptr, nullptr};
  std::string file_; // for messages
};

/// What is read while it lives is of one moment, whatever others write meanwhile. One within
/// another or within a Transaction reads what that does.
class ReadTransaction {
public:
  explicit ReadTransaction(const Database& database);
  ~ReadTransaction();
  ReadTransaction(const ReadTransaction&) = delete;
  ReadTransaction& operator=(const ReadTransaction&) = delete;

private:
  const Database* database_; // null: another one was open
};

/// Changes that come all or not at all: taken back unless committed.
class Transaction {
public:
  explicit Transaction(const Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();

private:
  const Database& database_;
  bool isOpen_ = true;
};

} // namespace espalier
