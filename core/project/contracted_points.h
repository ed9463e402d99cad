#pragma once

#include "core/project/history.h"

#include <Eigen/Core>

#include <memory>

namespace espalier {

class Project;

/// Contracted points of a scan, and the step that replaced those before by them.
struct ContractedPoints {
  StepId step = {};                                  // 0: they were there before the first
  std::shared_ptr<const Eigen::Matrix3Xf> positions; // as those of the scan; null: none
};

/// Those that are in a project.
/// @throws Error as Project::bytes and positionsFrom
[[nodiscard]] ContractedPoints contractedIn(const Project& project);

/// What the positions are called among the bytes of a project.
inline constexpr const char* contractedName = "contracted";

/// Drops those that are in a project, and notes which step the next ones come from; their positions
/// are for the caller to write.
void replaceContracted(Project& project, StepId step);

} // namespace espalier
