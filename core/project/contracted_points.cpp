#include "core/project/contracted_points.h"

#include "core/project/point_bytes.h"
#include "core/project/project.h"

#include <charconv>
#include <string>

namespace espalier {
namespace {

constexpr const char* stepName = "contracted_by"; // of the text with the id

} // namespace

ContractedPoints contractedIn(const Project& project) {
  const std::string bytes = project.bytes(contractedName);
  if (bytes.empty()) return {};
  const std::string text = project.document(stepName);
  std::uint64_t step = 0; // as it stays where there is no text
  (void)std::from_chars(text.data(), text.data() + text.size(), step);
  return {StepId{step}, std::make_shared<const Eigen::Matrix3Xf>(positionsFrom(bytes))};
}

// In this order: at no moment are there points that are said to be from another step.
void replaceContracted(Project& project, StepId step) {
  project.setBytes(contractedName, {});
  project.setDocument(stepName, std::to_string(static_cast<std::uint64_t>(step)));
}

} // namespace espalier
