#include "core/worklist/worklist.h"

#include "core/base/error.h"
#include "core/base/open_for_reading.h"
#include "core/base/text.h"
#include "core/io/csv.h"
#include "core/io/formats.h"

#include <algorithm>
#include <set>
#include <system_error>

namespace espalier {
namespace {

namespace fs = std::filesystem;

bool isProjectName(const fs::path& path) {
  return lowerCase(path.extension().string()) == ".espalier";
}

fs::path wholePath(const fs::path& path) {
  std::error_code failed;
  const fs::path whole = fs::weakly_canonical(path, failed);
  return failed ? fs::absolute(path) : whole;
}

bool isScanFile(const fs::path& path) {
  try {
    const Format& format = formatOf(path);
    return format.content == Content::points && format.canRead();
  } catch (const Error&) { // of no known kind, or not to be read
    return false;
  }
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    if (std::error_code ignored;
        entry.is_regular_file(ignored) && !entry.path().filename().string().starts_with('.'))
      files.push_back(entry.path());
  if (failed)
    throw Error(folder.string() + ": cannot be read: " + failed.message() +
                ": choose another folder");
  std::ranges::sort(files);
  return files;
}

/// Mostly a table or a note, though points can be written so.
bool isPlainText(const fs::path& path) {
  const std::string extension = lowerCase(path.extension().string());
  return extension == ".txt" || extension == ".csv";
}

Worklist worklistOfFolder(const fs::path& folder) {
  Worklist list{.place = folder};
  for (const fs::path& file : filesIn(folder)) {
    const bool isListed = isProjectName(file) || (!isPlainText(file) && isScanFile(file));
    if (isProjectName(file)) list.projects.push_back(file);
    if (isListed) list.lines.push_back({.file = file});
  }
  if (list.lines.empty())
    throw Error(folder.string() + ": holds no project and no scan: choose another folder, or name "
                                  "the files in a table");
  return list;
}

/// @param names  of files so far; that of this line is added
WorklistLine lineOf(const CsvTable& table, const CsvTable::Row& row, const fs::path& file,
                    std::set<fs::path>& names) {
  const auto field = [&](std::string_view name) {
    const std::optional<std::size_t> column = table.column(name);
    return column ? row.fields[*column] : std::string();
  };
  WorklistLine line{.annotator = field("annotator"), .second = field("second annotator")};
  const auto fail = [&](const std::string& problem) {
    line.problem = place(file.filename().string(), row.line) + problem;
    return line;
  };
  const std::string name = field("file");
  if (name.empty()) return fail("no file is named: write a project or a scan");
  const fs::path path = wholePath(file.parent_path() / name);
  std::error_code isMissing;
  if (!fs::is_regular_file(path, isMissing))
    return fail("there is no file " + inQuotes(name) + ": correct its name, or take the line out");
  if (!isProjectName(path) && !isScanFile(path))
    return fail(inQuotes(name) + " is neither a project nor a scan: name one of these");
  if (!names.insert(path).second) return fail(inQuotes(name) + " came before: take the line out");
  line.file = path;
  return line;
}

Worklist worklistOfTable(const fs::path& file) {
  const CsvTable table = readCsv(readText(file), file.string());
  if (!table.column("file"))
    throw Error(place(file.string(), 1) + "there is no column file: name the columns in the first "
                                          "line, as file,annotator,second annotator");
  Worklist list{.place = file, .isTable = true};
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const auto isKnown = [&](std::string_view name) { return table.column(name) == i; };
    if (isKnown("file") || isKnown("annotator") || isKnown("second annotator")) continue;
    others.push_back(i);
    list.others.push_back(table.names[i]);
  }
  std::set<fs::path> names;
  std::set<fs::path> folders;
  for (const CsvTable::Row& row : table.rows) {
    WorklistLine line = lineOf(table, row, file, names);
    for (const std::size_t i : others)
      line.others.push_back(row.fields[i]);
    if (!line.file.empty()) folders.insert(line.file.parent_path());
    list.lines.push_back(std::move(line));
  }
  if (list.lines.empty())
    throw Error(file.string() + ": no plant is listed: write a line for each below the first");
  for (const fs::path& folder : folders)
    for (const fs::path& each : filesIn(folder))
      if (isProjectName(each)) list.projects.push_back(each);
  return list;
}

// Rows.

const WorkState* stateIn(const KnownWorks& known, const fs::path& project) {
  const auto found = known.find(project);
  return found != known.end() && found->second.state ? &*found->second.state : nullptr;
}

bool isOfScan(const WorkState& state, const fs::path& scan) {
  if (!state.scan) return false;
  if (state.scan->path == scan) return true;
  std::error_code isMissing; // else it may have been moved along with its project
  return state.scan->path.filename() == scan.filename() &&
         fs::file_size(scan, isMissing) == state.scan->size && !isMissing;
}

/// The projects of a list by their scans.
class ProjectsByScan {
public:
  ProjectsByScan(const Worklist& list, const KnownWorks& known) : known_(known) {
    for (const fs::path& project : list.projects) {
      const WorkState* state = stateIn(known, project);
      isAllRead_ = isAllRead_ && known.contains(project);
      if (!state || !state->scan) continue;
      byName_[state->scan->path.filename()].push_back(project);
      byContent_[{state->scan->hash, state->scan->size}].push_back(project);
    }
  }

  [[nodiscard]] const KnownWorks& known() const { return known_; }
  [[nodiscard]] bool isAllRead() const { return isAllRead_; }
  [[nodiscard]] std::vector<fs::path> of(const fs::path& scan) const {
    const auto named = byName_.find(scan.filename());
    if (named == byName_.end()) return {};
    std::vector<fs::path> found;
    for (const fs::path& project : named->second)
      if (isOfScan(*stateIn(known_, project), scan)) found.push_back(project);
    return found;
  }
  [[nodiscard]] const std::vector<fs::path>& ofSame(const ScanReference& scan) const {
    return byContent_.at({scan.hash, scan.size});
  }

private:
  const KnownWorks& known_;
  bool isAllRead_ = true;
  std::map<fs::path, std::vector<fs::path>> byName_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<fs::path>> byContent_;
};

/// Of several projects of a scan, the one that a line of a table means; empty: there is none.
fs::path meantBy(const WorklistLine& line, const std::vector<fs::path>& projects,
                 const KnownWorks& known) {
  if (projects.empty()) return {};
  const auto isByAnnotator = [&](const fs::path& project) {
    return stateIn(known, project)->annotator == line.annotator;
  };
  const auto isNamedAlike = [&](const fs::path& project) {
    return project.stem() == line.file.stem();
  };
  if (!line.annotator.empty())
    if (const auto found = std::ranges::find_if(projects, isByAnnotator); found != projects.end())
      return *found;
  const auto found = std::ranges::find_if(projects, isNamedAlike);
  return found != projects.end() ? *found : projects.front();
}

void addSecond(WorklistRow& row, const ProjectsByScan& projects) {
  if (!row.state || !row.state->scan) return;
  for (const fs::path& project : projects.ofSame(*row.state->scan)) {
    const WorkState& other = *stateIn(projects.known(), project);
    const bool isMeant = row.second.empty()
                             ? !other.annotator.empty() && other.annotator != row.state->annotator
                             : other.annotator == row.second;
    if (project == row.project || !isMeant) continue;
    row.second = other.annotator;
    row.secondProject = project;
    return;
  }
}

WorklistRow rowOf(const WorklistLine& line, bool isTable, const ProjectsByScan& projects) {
  WorklistRow row{.annotator = line.annotator,
                  .second = line.second,
                  .others = line.others,
                  .problem = line.problem};
  if (line.file.empty()) return row;
  if (isProjectName(line.file)) {
    row.project = line.file;
  } else {
    row.scan = line.file;
    if (isTable) row.project = meantBy(line, projects.of(line.file), projects.known());
  }
  const auto found = projects.known().find(row.project);
  row.isRead = row.project.empty() ? projects.isAllRead() : found != projects.known().end();
  if (row.project.empty() || !row.isRead) return row;
  row.state = found->second.state;
  row.problem = found->second.problem;
  if (row.state && row.annotator.empty()) row.annotator = row.state->annotator;
  if (row.state && row.state->scan && row.scan.empty()) row.scan = row.state->scan->path;
  addSecond(row, projects);
  return row;
}

} // namespace

Worklist readWorklist(const fs::path& place) {
  const fs::path path = wholePath(place);
  std::error_code isMissing;
  return fs::is_directory(path, isMissing) ? worklistOfFolder(path) : worklistOfTable(path);
}

std::vector<WorklistRow> rowsOf(const Worklist& list, const KnownWorks& known) {
  const ProjectsByScan projects(list, known);
  std::vector<WorklistRow> rows;
  for (const WorklistLine& line : list.lines) {
    const bool isScan = !line.file.empty() && !isProjectName(line.file);
    if (!list.isTable && isScan && !projects.of(line.file).empty())
      continue; // that project is a row
    rows.push_back(rowOf(line, list.isTable, projects));
  }
  return rows;
}

} // namespace espalier
