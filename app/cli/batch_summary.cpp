#include "app/cli/batch_summary.h"

#include "core/base/error.h"
#include "core/base/open_for_reading.h"
#include "core/base/text.h"
#include "core/evaluate/scores.h"
#include "core/io/atomic_file.h"
#include "core/io/csv.h"

#include <functional>
#include <ostream>
#include <set>
#include <system_error>
#include <utility>

namespace espalier {
namespace {

struct Column {
  std::string name;
  std::function<std::string&(BatchResult&)> field;
};

constexpr const char* nameColumn = "name";
constexpr const char* statusColumn = "status";

Column columnOf(const char* name, std::string BatchResult::*member) {
  return {name, [member](BatchResult& result) -> std::string& { return result.*member; }};
}

void addScores(std::vector<Column>& columns, bool takeDistance) {
  for (const Score* score : scoresIn(inBrief))
    if (score->takesDistance == takeDistance)
      columns.push_back({score->key, [score](BatchResult& result) -> std::string& {
                           return result.scores[score->key];
                         }});
}

/// All columns behind name and status.
const std::vector<Column>& columns() {
  static const std::vector<Column> all = [] {
    std::vector<Column> made = {columnOf("points", &BatchResult::points),
                                columnOf("spacing", &BatchResult::spacing),
                                columnOf("nodes", &BatchResult::nodes),
                                columnOf("tips", &BatchResult::tips),
                                columnOf("length", &BatchResult::length),
                                columnOf("height", &BatchResult::height),
                                columnOf("root_radius", &BatchResult::rootRadius),
                                columnOf("unit", &BatchResult::unit),
                                columnOf("volume", &BatchResult::volume),
                                columnOf("stem_diameter", &BatchResult::stemDiameter),
                                columnOf("crown_area", &BatchResult::crownArea),
                                columnOf("expected_right", &BatchResult::expectedRight),
                                columnOf("doubts", &BatchResult::doubts)};
    addScores(made, false);
    made.push_back(columnOf("distance", &BatchResult::distance));
    addScores(made, true);
    made.push_back(columnOf("seconds", &BatchResult::seconds));
    made.push_back(columnOf("inputs", &BatchResult::inputs));
    made.push_back(columnOf("problem", &BatchResult::problem));
    return made;
  }();
  return all;
}

std::string headLine() {
  std::vector<std::string> names = {nameColumn, statusColumn};
  for (const Column& column : columns())
    names.push_back(column.name);
  return csvLine(names);
}

std::string lineOf(BatchResult result) {
  std::vector<std::string> fields = {result.name, result.isDone ? "done" : "failed"};
  for (const Column& column : columns())
    fields.push_back(column.field(result));
  return csvLine(fields);
}

BatchResult resultOf(const CsvTable& table, const CsvTable::Row& row) {
  BatchResult result;
  result.name = row.fields[*table.column(nameColumn)];
  result.isDone = row.fields[*table.column(statusColumn)] == "done";
  for (const Column& column : columns())
    if (const auto at = table.column(column.name)) column.field(result) = row.fields[*at];
  return result;
}

} // namespace

BatchSummary::BatchSummary(std::filesystem::path file) : file_(std::move(file)) {
  std::error_code isMissing;
  if (!std::filesystem::exists(file_, isMissing)) return;
  std::ifstream in = openForReading(file_);
  const CsvTable table = readCsv(readAll(in), file_.string());
  if (!table.column(nameColumn) || !table.column(statusColumn) || !table.column("inputs"))
    throw Error(file_.string() + ": is no summary of a batch: choose another folder");
  for (const CsvTable::Row& row : table.rows) {
    BatchResult result = resultOf(table, row);
    results_[result.name] = std::move(result);
  }
}

const BatchResult* BatchSummary::find(const std::string& name) const {
  const auto found = results_.find(name);
  return found == results_.end() ? nullptr : &found->second;
}

void BatchSummary::put(BatchResult result, const std::vector<std::string>& order) {
  results_[result.name] = std::move(result);
  writeAtomically(file_, [&](std::ostream& out) {
    out << headLine();
    for (const std::string& name : order)
      if (const BatchResult* each = find(name)) out << lineOf(*each);
    const std::set<std::string> listed(order.begin(), order.end());
    for (const auto& [name, each] : results_)
      if (each.isDone && !listed.contains(name)) out << lineOf(each);
  });
}

} // namespace espalier
