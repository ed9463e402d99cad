#include "app/cli/target_pairs.h"

#include "core/base/error.h"
#include "core/base/open_for_reading.h"
#include "core/base/text.h"
#include "core/io/csv.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace espalier {
namespace {

constexpr std::array<const char*, 6> pairColumns = {"x", "y", "z", "fixed_x", "fixed_y", "fixed_z"};
constexpr const char* pairHeader = "x,y,z,fixed_x,fixed_y,fixed_z";

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find_first_of(",;\t", begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

/// Whether a line has six numbers, and maybe a scan before them, rather than names of columns.
bool hasPair(std::string_view line) {
  const std::vector<std::string_view> fields = fieldsOf(line);
  if (fields.size() != 6 && fields.size() != 7) return false;
  return std::all_of(fields.end() - 6, fields.end(),
                     [](std::string_view field) { return numberIn(field).has_value(); });
}

/// The table; if its first line has a pair, with names of its columns before that.
CsvTable pairTable(const std::string& text, const std::string& file) {
  LineReader lines(text);
  std::optional<std::string_view> first = lines.next();
  while (first && trimmed(*first).empty())
    first = lines.next();
  if (!first || !hasPair(*first)) return readCsv(text, file);
  const std::size_t columns = fieldsOf(*first).size();
  while (const auto line = lines.next())
    if (fieldsOf(*line).size() > columns)
      throw Error(inEnglish(FilePlace{file, lines.number()}) + ": expected " +
                  std::to_string(columns) + " fields, as in the first line");
  std::string names = columns == 7 ? "scan," : "";
  names += pairHeader;
  std::ranges::replace(names, ',', (*first)[first->find_first_of(",;\t")]);
  const std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; // of UTF-8
  CsvTable table = readCsv(names + '\n' + text.substr(begin), file);
  for (CsvTable::Row& row : table.rows)
    --row.line;
  return table;
}

/// Which of the moved scans a field names, by its file or its number.
std::size_t movedScan(const std::string& field, const std::vector<std::string>& moved,
                      const FilePlace& where) {
  const auto isNamed = [&](const std::string& path) {
    return path == field || std::filesystem::path(path).filename() == field;
  };
  const auto named = std::ranges::find_if(moved, isNamed);
  if (named != moved.end()) {
    if (std::find_if(named + 1, moved.end(), isNamed) != moved.end())
      throw Error(inEnglish(where) + ": two scans are named " + inQuotes(field) +
                  ": write the number instead");
    return static_cast<std::size_t>(named - moved.begin());
  }
  for (std::size_t i = 0; i < moved.size(); ++i)
    if (field == std::to_string(i + 1)) return i;
  throw Error(inEnglish(where) + ": no scan " + inQuotes(field) +
              " is to be moved: write its file, or its number from 1");
}

} // namespace

std::vector<std::vector<TargetPair>> readTargetPairs(const std::filesystem::path& file,
                                                     const std::vector<std::string>& moved) {
  const CsvTable table = pairTable(readText(file), file.string());
  std::array<std::size_t, 6> columns{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto column = table.column(pairColumns[i]);
    if (!column)
      throw Error(inEnglish(FilePlace{file.string(), 1}) + ": there is no column " +
                  pairColumns[i] + ": name the columns in the first line, as " + pairHeader);
    columns[i] = *column;
  }
  const std::optional<std::size_t> scan = table.column("scan");
  if (!scan && moved.size() > 1)
    throw Error(inEnglish(FilePlace{file.string(), 1}) +
                ": there is no column scan: it says which of the moved scans a pair is of");
  std::vector<std::vector<TargetPair>> pairs(moved.size());
  for (const CsvTable::Row& row : table.rows) {
    const FilePlace where{file.string(), row.line};
    const auto number = [&](std::size_t i) {
      return finiteNumber(row.fields[columns[i]], pairColumns[i], where);
    };
    const std::size_t of = scan ? movedScan(row.fields[*scan], moved, where) : 0;
    pairs[of].push_back(
        {.moved = {number(0), number(1), number(2)}, .fixed = {number(3), number(4), number(5)}});
  }
  return pairs;
}

} // namespace espalier
