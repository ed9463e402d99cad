#include "core/io/csv.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>

namespace espalier {
namespace {

/// Parts a text into rows of fields.
class CsvReader {
public:
  CsvReader(std::string_view text, const std::string& file) : text_(text), file_(file) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    const std::string_view first = text_.substr(0, text_.find('\n'));
    for (const char sign : {',', ';', '\t'})
      if (first.find(sign) != std::string_view::npos) {
        sign_ = sign;
        break;
      }
  }

  [[nodiscard]] bool atEnd() const { return at_ == text_.size(); }

  CsvTable::Row row() {
    CsvTable::Row result{.line = line_, .fields = {}};
    for (bool goesOn = true; goesOn;) {
      result.fields.push_back(isQuoted() ? quoted() : plain());
      goesOn = !atEnd() && text_[at_] == sign_;
      if (!atEnd() && !goesOn) ++line_; // a line end
      if (!atEnd()) ++at_;
    }
    return result;
  }

private:
  bool isQuoted() {
    std::size_t next = at_;
    while (next < text_.size() && text_[next] == ' ')
      ++next;
    if (next == text_.size() || text_[next] != '"') return false;
    at_ = next + 1;
    return true;
  }

  std::string plain() {
    const std::size_t start = at_;
    while (!atEnd() && text_[at_] != sign_ && text_[at_] != '\n')
      ++at_;
    return std::string(trimmed(text_.substr(start, at_ - start)));
  }

  std::string quoted() {
    const std::size_t start = line_;
    std::string field;
    for (;; ++at_) {
      if (atEnd())
        throw Error(place(file_, start) + "a quote is not closed: end the field with \"");
      if (text_[at_] == '"') {
        if (at_ + 1 == text_.size() || text_[at_ + 1] != '"') break;
        ++at_;
      }
      if (text_[at_] == '\n') ++line_;
      field += text_[at_];
    }
    ++at_;
    if (!plain().empty())
      throw Error(place(file_, line_) +
                  "there is text behind a quoted field: quote all of it, and write \"\" for a "
                  "quote in it");
    return field;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  char sign_ = ',';
};

bool isBlank(const CsvTable::Row& row) {
  return std::ranges::all_of(row.fields, &std::string::empty);
}

void requireNames(const CsvTable& table, const std::string& file) {
  for (auto name = table.names.begin(); name != table.names.end(); ++name) {
    const auto isSame = [&](const std::string& other) {
      return !name->empty() && lowerCase(other) == lowerCase(*name);
    };
    if (std::any_of(table.names.begin(), name, isSame))
      throw Error(place(file, 1) + "two columns are named " + inQuotes(*name) + ": rename one");
  }
}

} // namespace

std::optional<std::size_t> CsvTable::column(std::string_view name) const {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (lowerCase(names[i]) == lowerCase(name)) return i;
  return std::nullopt;
}

CsvTable readCsv(std::string_view text, const std::string& file) {
  CsvReader reader(text, file);
  CsvTable table;
  if (!reader.atEnd()) table.names = reader.row().fields;
  if (std::ranges::all_of(table.names, &std::string::empty))
    throw Error(place(file, 1) + "there are no names of columns: begin with a line of names");
  requireNames(table, file);
  while (!reader.atEnd()) {
    CsvTable::Row row = reader.row();
    if (isBlank(row)) continue;
    if (row.fields.size() > table.names.size())
      throw Error(place(file, row.line) + "expected " + std::to_string(table.names.size()) +
                  " fields, found " + std::to_string(row.fields.size()) +
                  ": quote fields that hold the sign that parts them");
    row.fields.resize(table.names.size());
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string csvLine(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string& field = fields[i];
    line += i == 0 ? "" : ",";
    const bool isPlain =
        field.find_first_of(",;\t\r\n\"") == std::string::npos && trimmed(field) == field;
    if (isPlain) {
      line += field;
      continue;
    }
    line += '"';
    for (const char sign : field)
      line += sign == '"' ? std::string("\"\"") : std::string(1, sign);
    line += '"';
  }
  return line + '\n';
}

} // namespace espalier
