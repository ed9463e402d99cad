#include "app/cli/files.h"

#include "app/cli/arguments.h"
#include "app/cli/terminal.h"
#include "core/base/counted.h"
#include "core/io/atomic_file.h"
#include "core/io/dropped.h"
#include "core/skeleton/axes.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>
#include <system_error>

namespace espalier {

void requireApart(const std::vector<std::string>& outputs) {
  std::set<std::filesystem::path> places;
  for (const std::string& output : outputs)
    if (!output.empty() && !isStream(output) && !places.insert(placeOf(output)).second)
      throw WrongUsage("two results would be written to " + output +
                       ": give each a file of its own");
}

void requireOutput(const std::string& path, const std::vector<std::string>& inputs) {
  if (path.empty()) return;
  for (const std::string& input : inputs) {
    std::error_code isMissing;
    if (std::filesystem::is_regular_file(path, isMissing) &&
        std::filesystem::equivalent(input, path, isMissing))
      throw Error(path + ": is what is read, and would be replaced: choose another output file");
  }
  requireWritable(path);
  if (!isStream(path)) removeLeftovers(placeOf(path).parent_path());
}

void requireOutput(const std::string& path, Content content,
                   const std::vector<std::string>& inputs) {
  (void)formatToWrite(path, content);
  requireOutput(path, inputs);
}

void writeAndReport(const std::string& path, const std::function<void(std::ostream&)>& write,
                    const std::string& what) {
  if (path.empty()) return;
  std::fflush(stdout); // what is printed stands before what is written to /dev/stdout
  writeAtomically(path, write);
  printWritten(what.empty() ? path : path + ": " + what);
}

std::string textOf(const nlohmann::ordered_json& json) {
  constexpr int blanks = 2;
  try {
    return json.dump(blanks) + '\n';
  } catch (const nlohmann::json::type_error&) { // the only one that writing knows: no UTF-8
    printNotes({"a name is no UTF-8, as JSON is: it is written with \uFFFD for what JSON cannot "
                "hold"});
    return json.dump(blanks, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  }
}

void writeJson(const std::string& path, const nlohmann::ordered_json& json) {
  if (path.empty()) return;
  const std::string text = textOf(json);
  writeAndReport(path, [&](std::ostream& out) { out << text; });
}

void writeAndReport(const std::string& path, const Structure& structure, MtgStyle style,
                    const std::string& unit) {
  writeStructure(path, structure, style);
  const Format& format = formatToWrite(path, Content::structure);
  if (isWithoutPositions(structure)) {
    const std::size_t vertices = structure.frame->mtg.vertices.size();
    printWritten(path + ": " + std::to_string(vertices) +
                 (vertices == 1 ? " vertex" : " vertices") + " without positions");
    return printNotes(eachInEnglish(droppedBy(format, structure)));
  }
  double total = 0;
  for (const Axis& axis : axes(structure.skeleton))
    total += length(structure.skeleton, axis);
  std::ostringstream text;
  text.precision(6);
  text << path << ": " << counted(structure.skeleton.size(), "node") << ", length " << total
       << (unit.empty() ? "" : " ") << unit;
  printWritten(text.str());
  printNotes(eachInEnglish(droppedBy(format, structure.skeleton)));
}

void writeAndReport(const std::string& path, const PointCloud& cloud,
                    const Eigen::Matrix3Xf& positions, const Progress& progress) {
  writePoints(path, cloud, positions, progress);
  printWritten(path + ": " + counted(static_cast<std::size_t>(cloud.size()), "point"));
}

} // namespace espalier
