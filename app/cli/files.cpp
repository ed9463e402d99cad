#include "app/cli/files.h"

#include "app/cli/terminal.h"
#include "core/io/atomic_file.h"
#include "core/io/dropped.h"

#include <filesystem>
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

void writeStructureWithNotes(const std::string& path, const Structure& structure) {
  writeStructure(path, structure);
  printNotes(droppedBy(formatToWrite(path, Content::structure), structure.skeleton));
}

} // namespace espalier
