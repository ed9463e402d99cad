#include "core/io/csv.h"

#include "core/base/text.h"
#include "core/base/utf16.h"

#include <algorithm>
#include <utility>

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
        throw ShownError({espalier::Shown::tr("a quote is not closed: end the field with \""),
                          {},
                          FilePlace{file_, start}});
      if (text_[at_] == '"') {
        if (at_ + 1 == text_.size() || text_[at_ + 1] != '"') break;
        ++at_;
      }
      if (text_[at_] == '\n') ++line_;
      field += text_[at_];
    }
    ++at_;
    if (!plain().empty())
      throw ShownError({espalier::Shown::tr("there is text behind a quoted field: quote all of it, "
                                            "and write \"\" for a quote in it"),
                        {},
                        FilePlace{file_, line_}});
    return field;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  char sign_ = ',';
};

/// Whether a field begins as a formula does, and is no number.
bool beginsAsFormula(std::string_view field) {
  const bool begins = field.size() > 1 && std::string_view("=+-@").find(field[0]) < 4;
  return begins && !numberIn(field);
}

/// Whether a field is numbers with blanks between them: a position.
bool areNumbers(std::string_view field) {
  while (!field.empty()) {
    const std::size_t end = std::min(field.find(' '), field.size());
    if (!numberIn(field.substr(0, end))) return false;
    field.remove_prefix(std::min(end + 1, field.size()));
  }
  return true;
}

/// Whether a spreadsheet would compute a field instead of showing it.
bool isFormula(std::string_view field) {
  return beginsAsFormula(field) && !areNumbers(field);
}

/// Whether a field looks like a formula behind apostrophes: then one more is written before it, and
/// taken off when it is read, so that each text reads back as it was. Earlier files have one before
/// numbers, too.
bool isQuotedFormula(std::string_view field) {
  const std::size_t first = field.find_first_not_of('\'');
  return first != std::string_view::npos && first > 0 && beginsAsFormula(field.substr(first));
}

/// Fields without the apostrophes that csvLine has put before formulas.
std::vector<std::string> asWritten(std::vector<std::string> fields) {
  for (std::string& field : fields)
    if (isQuotedFormula(field)) field.erase(0, 1);
  return fields;
}

bool isBlank(const CsvTable::Row& row) {
  return std::ranges::all_of(row.fields, &std::string::empty);
}

void requireNames(const CsvTable& table, const std::string& file) {
  constexpr std::size_t most = 1000;
  if (table.names.size() > most)
    throw ShownError(
        {espalier::Shown::tr("there are %1 columns, more than in any such table: leave "
                             "out those that are not needed"),
         {std::to_string(table.names.size())},
         FilePlace{file, 1}});
  for (auto name = table.names.begin(); name != table.names.end(); ++name) {
    const auto isSame = [&](const std::string& other) {
      return !name->empty() && lowerCase(other) == lowerCase(*name);
    };
    if (std::any_of(table.names.begin(), name, isSame))
      throw ShownError({espalier::Shown::tr("two columns are named %1: rename one"),
                        {inQuotes(*name)},
                        FilePlace{file, 1}});
  }
}

} // namespace

std::optional<std::size_t> CsvTable::column(std::string_view name) const {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (lowerCase(names[i]) == lowerCase(name)) return i;
  return std::nullopt;
}

CsvTable readCsv(std::string_view text, const std::string& file) {
  requireNoUtf16(text, file);
  CsvReader reader(text, file);
  CsvTable table;
  if (!reader.atEnd()) table.names = asWritten(reader.row().fields);
  if (std::ranges::all_of(table.names, &std::string::empty))
    throw ShownError(
        {espalier::Shown::tr("there are no names of columns: begin with a line of names"),
         {},
         FilePlace{file, 1}});
  requireNames(table, file);
  while (!reader.atEnd()) {
    CsvTable::Row row = reader.row();
    if (isBlank(row)) continue;
    if (row.fields.size() > table.names.size())
      throw ShownError({espalier::Shown::tr("expected %1 fields, found %2: quote fields that hold "
                                            "the sign that parts them"),
                        {std::to_string(table.names.size()), std::to_string(row.fields.size())},
                        FilePlace{file, row.line}});
    row.fields = asWritten(std::move(row.fields));
    row.fields.resize(table.names.size());
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string csvLine(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool isCode = isFormula(fields[i]) || isQuotedFormula(fields[i]);
    const std::string field = (isCode ? "'" : "") + fields[i];
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
