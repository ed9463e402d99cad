#pragma once

#include "core/base/shown_message.h"
#include "core/project/work_state.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {

/// A plant as a worklist names it.
struct WorklistLine {
  std::filesystem::path file; // a project or a scan, absolute; empty where the line has a problem
  std::string named = {};     // as a table names it, its beginning; of a folder empty
  std::string annotator = {}; // as a table has it; empty: not named
  std::string second = {};    // likewise, who annotates the plant beside
  std::vector<std::string> others = {};     // what a table has in its further columns
  std::optional<ShownMessage> problem = {}; // of the line, which it names
};

/// Plants that are worked on one after another.
struct Worklist {
  std::filesystem::path place;     // a folder or a table, absolute
  std::vector<std::string> others; // names of the further columns of a table
  std::vector<WorklistLine> lines;
  bool isTable = false;
  /// All that lie in the folders of the lines, sorted; those of a table may name the scans alone.
  std::vector<std::filesystem::path> projects;
};

/// Reads which plants there are: the projects and scans of a folder, without those below it, or a
/// CSV table with a column `file`, or `scan` as batches have it, and those named `annotator` and
/// `second annotator` if it has them. No project or scan is opened; a folder is asked for the
/// beginning of its files.
///
/// In a folder, texts named .txt and .csv are left out, which mostly are no scans. Files of a table
/// are sought from its folder. A link stands for the file it leads to. A line has a problem if it
/// names no file, one that is not there, one that is neither project nor scan, one that came
/// before, one whose name is no UTF-8, or an annotator by over 200 bytes; of what is longer in a
/// further column, the beginning is kept.
///
/// @throws Error if the place cannot be read, a table has neither of these columns, or no plant is
/// found
[[nodiscard]] Worklist readWorklist(const std::filesystem::path& place);

/// What is known of a project or scan.
struct KnownWork {
  std::optional<WorkState> state = {};      // of a project that can be read
  std::optional<ShownMessage> problem = {}; // why not, or not all of it; of a scan, too
  std::optional<std::uint64_t> hash = {};   // contentHashOfFile of a scan, where it was asked for
};
using KnownWorks = std::map<std::filesystem::path, KnownWork>; // by the path of the file

/// A plant of a worklist, with what is known of it.
struct WorklistRow {
  std::filesystem::path project = {}; // empty: none is known
  std::filesystem::path scan = {};    // empty: none is known, or it is no file of its own
  std::string named = {};             // as in its line
  std::string annotator = {};
  std::string second = {};
  std::filesystem::path secondProject = {}; // of the second annotator; empty: none
  std::vector<std::string> others = {};
  std::optional<WorkState> state = {}; // none: not read yet, there is no project, or a problem
  std::optional<ShownMessage> problem = {};
  bool isRead = true; // false: its project, or whether there is one, is not known yet

  /// The file to open: the project, else the scan.
  [[nodiscard]] const std::filesystem::path& file() const {
    return project.empty() ? scan : project;
  }
  [[nodiscard]] WorkStage stage() const { return state ? state->stage : WorkStage::toDo; }
};

/// The rows of a worklist as far as its projects are known.
///
/// In a folder, each project is a row, and each scan that no project is of. In a table, each line
/// is: one that names a scan has the project of that scan by its annotator, else one that is named
/// like the scan, else the first by name; one whose project came before has a problem. A project is
/// of a scan that lies where it was found last; or that has its name and its content, where nothing
/// lies there any more. The second project is one of the same scan by the second annotator, or by
/// any other where a table names none. Time O(N log N).
[[nodiscard]] std::vector<WorklistRow> rowsOf(const Worklist& list, const KnownWorks& known);

/// The scans whose content says whether they are that of a project: their hashes are not known yet.
/// Few, mostly none: those that have name and size of one that was moved. Time O(N log N).
[[nodiscard]] std::vector<std::filesystem::path> scansToHash(const Worklist& list,
                                                             const KnownWorks& known);

} // namespace espalier
