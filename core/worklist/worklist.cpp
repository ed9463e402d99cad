#include "core/worklist/worklist.h"

#include "core/base/error.h"
#include "core/base/open_for_reading.h"
#include "core/base/printable.h"
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

/// What an entry of a folder stands for: that which a link leads to, unless its name says less.
fs::path fileOf(const fs::path& entry) {
  const fs::path whole = wholePath(entry);
  const bool isAsGood = isProjectName(entry) ? isProjectName(whole) : isScanFile(whole);
  return isAsGood ? whole : entry;
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> files;
  fs::directory_iterator entry(folder, failed);
  for (; !failed && entry != fs::directory_iterator(); entry.increment(failed))
    if (std::error_code ignored;
        entry->is_regular_file(ignored) && !entry->path().filename().string().starts_with('.'))
      files.push_back(entry->is_symlink(ignored) ? fileOf(entry->path()) : entry->path());
  if (failed)
    throw ShownError({Shown::tr("cannot be read: %1: choose another folder"),
                      {failed.message()},
                      FilePlace{folder.string()}});
  std::ranges::sort(files);
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

/// None: it is good.
std::optional<ShownMessage> problemOfName(const fs::path& file) {
  if (isUtf8(file.string())) return std::nullopt;
  return ShownMessage{
      espalier::Shown::tr("its name is no UTF-8: rename it"), {}, FilePlace{file.string()}};
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
    if (isListed) list.lines.push_back({.file = file, .problem = problemOfName(file)});
  }
  if (list.lines.empty())
    throw ShownError({Shown::tr("holds no project and no scan itself: choose the folder that they "
                                "lie in, or name them in a table"),
                      {},
                      FilePlace{folder.string()}});
  return list;
}

constexpr std::size_t mostBytes = 200; // of a field: it is shown on one line

/// The beginning of a long text, cut between its letters.
std::string shortened(const std::string& text) {
  if (text.size() <= mostBytes) return text;
  std::size_t end = mostBytes;
  const auto isWithin = [&](std::size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
  };
  while (end > 0 && isWithin(end))
    --end;
  return text.substr(0, end) + "…";
}

/// The column that names the plants, `scan` in tables of batches; none: the table has none.
std::optional<std::size_t> columnOfFiles(const CsvTable& table) {
  const std::optional<std::size_t> column = table.column("file");
  return column ? column : table.column("scan");
}

/// @param names  of files so far; that of this line is added
WorklistLine lineOf(const CsvTable& table, const CsvTable::Row& row, const fs::path& file,
                    std::set<fs::path>& names) {
  const auto field = [&](std::string_view name) {
    const std::optional<std::size_t> column = table.column(name);
    return column ? row.fields[*column] : std::string();
  };
  const std::string name = row.fields[*columnOfFiles(table)];
  WorklistLine line{.named = shortened(name),
                    .annotator = shortened(field("annotator")),
                    .second = shortened(field("second annotator"))};
  const auto fail = [&](const char* sentence, std::vector<std::string> values = {}) {
    line.problem =
        ShownMessage{sentence, std::move(values), FilePlace{file.filename().string(), row.line}};
    return line;
  };
  if (name.empty()) return fail(Shown::tr("no file is named: write a project or a scan"));
  for (const char* column : {"annotator", "second annotator"})
    if (field(column).size() > mostBytes)
      return fail(Shown::tr("the %1 has over %2 bytes: write a shorter name"),
                  {column, std::to_string(mostBytes)});
  const fs::path path = wholePath(file.parent_path() / name);
  std::error_code isMissing;
  if (!fs::is_regular_file(path, isMissing))
    return fail(Shown::tr("there is no file %1: correct its name, or take the line out"),
                {inQuotes(name)});
  if (!isProjectName(path) && !isScanFile(path))
    return fail(Shown::tr("%1 is neither a project nor a scan: name one of these"),
                {inQuotes(name)});
  if (!names.insert(path).second)
    return fail(Shown::tr("%1 came before: take the line out"), {inQuotes(name)});
  if (!isUtf8(path.string()))
    return fail(Shown::tr("%1 is no UTF-8: rename the file"), {inQuotes(name)});
  line.file = path;
  return line;
}

Worklist worklistOfTable(const fs::path& file) {
  const CsvTable table = readCsv(readText(file), file.string());
  const std::optional<std::size_t> files = columnOfFiles(table);
  if (!files)
    throw ShownError({Shown::tr("there is no column %1: name the columns in the first line, as %2"),
                      {inQuotes("file"), inQuotes("file,annotator,second annotator")},
                      FilePlace{file.string(), 1}});
  Worklist list{.place = file, .isTable = true};
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const auto isKnown = [&](std::string_view name) { return table.column(name) == i; };
    if (i == *files || isKnown("annotator") || isKnown("second annotator")) continue;
    others.push_back(i);
    list.others.push_back(shortened(table.names[i]));
  }
  std::set<fs::path> names;
  std::set<fs::path> folders;
  for (const CsvTable::Row& row : table.rows) {
    WorklistLine line = lineOf(table, row, file, names);
    for (const std::size_t i : others)
      line.others.push_back(shortened(row.fields[i]));
    if (!line.file.empty()) folders.insert(line.file.parent_path());
    list.lines.push_back(std::move(line));
  }
  if (list.lines.empty())
    throw ShownError({Shown::tr("no plant is listed: write a line for each below the first"),
                      {},
                      FilePlace{file.string()}});
  for (const fs::path& folder : folders)
    for (const fs::path& each : filesIn(folder))
      if (isProjectName(each)) list.projects.push_back(each);
  for (const WorklistLine& line : list.lines)
    if (isProjectName(line.file)) list.projects.push_back(line.file); // it may be hidden there
  std::ranges::sort(list.projects);
  list.projects.erase(std::unique(list.projects.begin(), list.projects.end()), list.projects.end());
  return list;
}

// Rows.

const WorkState* stateIn(const KnownWorks& known, const fs::path& project) {
  const auto found = known.find(project);
  return found != known.end() && found->second.state ? &*found->second.state : nullptr;
}

enum class Match : std::uint8_t { no, yes, byContent }; // by a hash that is not known yet

Match matchOf(const ScanReference& reference, const fs::path& scan, const KnownWorks& known) {
  if (reference.path == scan) return Match::yes;
  std::error_code failed; // else it may have been moved along with its project
  if (reference.path.filename() != scan.filename() ||
      fs::file_size(scan, failed) != reference.size || failed)
    return Match::no;
  if (fs::exists(reference.path, failed))
    return fs::equivalent(reference.path, scan, failed) ? Match::yes : Match::no;
  const auto found = known.find(scan);
  if (found != known.end() && found->second.problem) return Match::no;
  if (found == known.end() || !found->second.hash) return Match::byContent;
  return *found->second.hash == reference.hash ? Match::yes : Match::no;
}

/// The projects of a scan.
struct ProjectsOfScan {
  std::vector<fs::path> found;
  bool isKnown = true;    // false: there may be more
  bool needsHash = false; // of the scan, to know
};

/// The projects of a list by their scans.
class ProjectsByScan {
public:
  ProjectsByScan(const Worklist& list, const KnownWorks& known) : known_(known) {
    for (const fs::path& project : list.projects) {
      const WorkState* state = stateIn(known, project);
      isAllRead_ = isAllRead_ && known.contains(project);
      if (!state || !state->scan) continue;
      byName_[state->scan->path.filename()].push_back(project);
      OfContent& same = byContent_[{state->scan->hash, state->scan->size}];
      std::vector<fs::path>& theirs = same.byAnnotator[state->annotator];
      if (theirs.empty() && !state->annotator.empty()) same.firsts.push_back(project);
      theirs.push_back(project);
    }
  }

  [[nodiscard]] const KnownWorks& known() const { return known_; }
  [[nodiscard]] bool isAllRead() const { return isAllRead_; }
  [[nodiscard]] ProjectsOfScan of(const fs::path& scan) const {
    ProjectsOfScan projects{.found = {}, .isKnown = isAllRead_};
    const auto named = byName_.find(scan.filename());
    if (named == byName_.end()) return projects;
    for (const fs::path& project : named->second) {
      const Match match = matchOf(*stateIn(known_, project)->scan, scan, known_);
      if (match == Match::yes) projects.found.push_back(project);
      projects.needsHash = projects.needsHash || match == Match::byContent;
    }
    projects.isKnown = isAllRead_ && !projects.needsHash;
    return projects;
  }
  /// Another project of the scan of this one: by that annotator, or, if empty, by the first who is
  /// another. Empty: there is none.
  [[nodiscard]] fs::path second(const fs::path& project, const WorkState& state,
                                const std::string& annotator) const {
    const auto same = byContent_.find({state.scan->hash, state.scan->size});
    if (same == byContent_.end()) return {};
    const auto firstOf = [&](const std::vector<fs::path>& others) { // or the second of them
      const auto found = std::ranges::find_if(others, [&](const fs::path& other) {
        return other != project &&
               (!annotator.empty() || stateIn(known_, other)->annotator != state.annotator);
      });
      return found == others.end() ? fs::path() : *found;
    };
    if (annotator.empty()) return firstOf(same->second.firsts);
    const auto theirs = same->second.byAnnotator.find(annotator);
    return theirs == same->second.byAnnotator.end() ? fs::path() : firstOf(theirs->second);
  }

private:
  struct OfContent {
    std::map<std::string, std::vector<fs::path>> byAnnotator;
    std::vector<fs::path> firsts; // of each annotator that has a name
  };
  const KnownWorks& known_;
  bool isAllRead_ = true;
  std::map<fs::path, std::vector<fs::path>> byName_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, OfContent> byContent_;
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
  row.secondProject = projects.second(row.project, *row.state, row.second);
  if (!row.secondProject.empty())
    row.second = stateIn(projects.known(), row.secondProject)->annotator;
}

WorklistRow rowOf(const WorklistLine& line, bool isTable, const ProjectsByScan& projects) {
  WorklistRow row{.named = line.named,
                  .annotator = line.annotator,
                  .second = line.second,
                  .others = line.others,
                  .problem = line.problem};
  if (line.file.empty()) return row;
  bool isKnown = true; // whether there is a project
  if (isProjectName(line.file)) {
    row.project = line.file;
  } else {
    row.scan = line.file;
    const ProjectsOfScan of = projects.of(line.file);
    isKnown = of.isKnown;
    if (isTable) row.project = meantBy(line, of.found, projects.known());
  }
  const auto found = projects.known().find(row.file());
  const bool isFileKnown = found != projects.known().end();
  row.isRead = isKnown && (row.project.empty() || isFileKnown);
  if (isFileKnown && !row.problem) row.problem = found->second.problem;
  if (row.project.empty() || !row.isRead) return row;
  row.state = found->second.state;
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
  std::set<fs::path> before;
  for (const WorklistLine& line : list.lines) {
    const bool isScan = !line.file.empty() && !isProjectName(line.file);
    if (!list.isTable && isScan && !projects.of(line.file).found.empty())
      continue; // that project is a row
    WorklistRow row = rowOf(line, list.isTable, projects);
    if (!row.project.empty() && !before.insert(row.project).second)
      row.problem =
          ShownMessage{Shown::tr("a line before means this plant, too: take one of the two out"),
                       {},
                       FilePlace{row.project.string()}};
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<fs::path> scansToHash(const Worklist& list, const KnownWorks& known) {
  const ProjectsByScan projects(list, known);
  std::vector<fs::path> scans;
  for (const WorklistLine& line : list.lines)
    if (!line.file.empty() && !isProjectName(line.file) && projects.of(line.file).needsHash)
      scans.push_back(line.file);
  return scans;
}

} // namespace espalier
