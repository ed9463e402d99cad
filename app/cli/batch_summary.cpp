#include "app/cli/batch_summary.h"

#include "core/base/error.h"
#include "core/base/open_for_reading.h"
#include "core/base/text.h"
#include "core/io/atomic_file.h"
#include "core/io/csv.h"

#include <ostream>
#include <set>
#include <system_error>
#include <utility>

namespace espalier {
namespace {

struct Column {
  const char* name;
  std::string BatchResult::*member;
};

constexpr const char* nameColumn = "name";
constexpr const char* statusColumn = "status";

/// All columns behind name and status.
constexpr Column columns[] = {{"points", &BatchResult::points},
                              {"spacing", &BatchResult::spacing},
                              {"nodes", &BatchResult::nodes},
                              {"tips", &BatchResult::tips},
                              {"length", &BatchResult::length},
                              {"height", &BatchResult::height},
                              {"root_radius", &BatchResult::rootRadius},
                              {"geometric", &BatchResult::geometric},
                              {"structural", &BatchResult::structural},
                              {"distance", &BatchResult::distance},
                              {"f", &BatchResult::f},
                              {"seconds", &BatchResult::seconds},
                              {"inputs", &BatchResult::inputs},
                              {"problem", &BatchResult::problem}};

std::string headLine() {
  std::vector<std::string> names = {nameColumn, statusColumn};
  for (const Column& column : columns)
    names.emplace_back(column.name);
  return csvLine(names);
}

std::string lineOf(const BatchResult& result) {
  std::vector<std::string> fields = {result.name, result.isDone ? "done" : "failed"};
  for (const Column& column : columns)
    fields.push_back(result.*column.member);
  return csvLine(fields);
}

BatchResult resultOf(const CsvTable& table, const CsvTable::Row& row) {
  BatchResult result;
  result.name = row.fields[*table.column(nameColumn)];
  result.isDone = row.fields[*table.column(statusColumn)] == "done";
  for (const Column& column : columns)
    if (const auto at = table.column(column.name)) result.*column.member = row.fields[*at];
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
