#include "core/project/project_frame.h"

#include "core/mtg/mtg_reader.h"

#include <sstream>
#include <string>
#include <utility>

namespace espalier {

std::shared_ptr<const MtgFrame> frameOf(const Project& project) {
  std::string text = project.document("mtg");
  if (text.empty()) return nullptr;
  std::istringstream in(text);
  Mtg mtg = readMtg(in, project.path().string()).value;
  return std::make_shared<const MtgFrame>(MtgFrame{std::move(mtg), std::move(text)});
}

} // namespace espalier
