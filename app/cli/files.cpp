#include "app/cli/files.h"

#include "app/cli/terminal.h"
#include "core/io/atomic_file.h"
#include "core/io/dropped.h"
#include "core/skeleton/axes.h"

#include <filesystem>
#include <sstream>
#include <system_error>

namespace espalier {

void requireOutput(const std::string& path, const std::vector<std::string>& inputs) {
  if (path.empty()) return;
  for (const std::string& input : inputs) {
    std::error_code isMissing;
    if (std::filesystem::is_regular_file(path, isMissing) &&
        std::filesystem::equivalent(input, path, isMissing))
      throw Error(path + ": is what is read, and would be replaced: choose another output file");
  }
  requireWritable(path);
}

void requireOutput(const std::string& path, Content content,
                   const std::vector<std::string>& inputs) {
  (void)formatToWrite(path, content);
  requireOutput(path, inputs);
}

void writeAndTell(const std::string& path, const std::function<void(std::ostream&)>& write,
                  const std::string& what) {
  if (path.empty()) return;
  writeAtomically(path, write);
  printWritten(what.empty() ? path : path + ": " + what);
}

void writeAndTell(const std::string& path, const Structure& structure, MtgStyle style,
                  const std::string& unit) {
  writeStructure(path, structure, style);
  double total = 0;
  for (const Axis& axis : axes(structure.skeleton))
    total += length(structure.skeleton, axis);
  std::ostringstream text;
  text.precision(6);
  const std::size_t nodes = structure.skeleton.size();
  text << path << ": " << nodes << (nodes == 1 ? " node" : " nodes") << ", length " << total
       << (unit.empty() ? "" : " ") << unit;
  printWritten(text.str());
  printNotes(droppedBy(formatToWrite(path, Content::structure), structure.skeleton));
}

void writeAndTell(const std::string& path, const PointCloud& cloud,
                  const Eigen::Matrix3Xf& positions) {
  writePoints(path, cloud, positions);
  printWritten(path + ": " + std::to_string(cloud.size()) + " points");
}

} // namespace espalier
