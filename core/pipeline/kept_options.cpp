#include "core/pipeline/kept_options.h"

#include "core/base/shown_message.h"
#include "core/pipeline/preset.h"

#include <limits>
#include <sstream>
#include <string_view>

namespace espalier {
namespace {

constexpr std::string_view upNames = "xyz"; // in the order of UpAxis

UpAxis axisOf(const std::string& name) {
  const std::size_t axis = name.size() == 1 ? upNames.find(name) : std::string_view::npos;
  if (axis == std::string_view::npos)
    throw ShownError({espalier::Shown::tr("\"%1\" is no axis that points up"), {name}});
  return static_cast<UpAxis>(axis);
}

Eigen::Vector3d rootIn(std::istream& in) {
  Eigen::Vector3d root;
  if (!(in >> root.x() >> root.y() >> root.z()) || !root.allFinite())
    throw ShownError({espalier::Shown::tr("the root of the plant is no place")});
  return root;
}

} // namespace

std::string keptText(const PipelineOptions& options) {
  std::ostringstream text;
  if (options.up != UpAxis::z)
    text << "up " << upNames[static_cast<std::size_t>(options.up)] << '\n';
  text.precision(std::numeric_limits<double>::max_digits10);
  if (options.root) text << "root " << options.root->transpose() << '\n';
  writePreset(text, options);
  return text.str();
}

PipelineOptions keptOptions(const std::string& text) {
  std::istringstream in(text);
  PipelineOptions ofScan;
  for (std::string name; in >> std::ws && in.peek() != '{' && in >> name;) {
    std::string axis;
    if (name == "up" && in >> axis)
      ofScan.up = axisOf(axis);
    else if (name == "root")
      ofScan.root = rootIn(in);
    else
      throw ShownError({espalier::Shown::tr("\"%1\" is no option of a project"), {name}});
  }
  PipelineOptions options = readPreset(in);
  requireKnown(options);
  options.up = ofScan.up;
  options.root = ofScan.root;
  return options;
}

} // namespace espalier
