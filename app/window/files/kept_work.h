#pragma once

#include "core/project/project.h"

#include <array>

namespace espalier {

/// Names of the texts of a project that are decisions of a hand without being edits: what is
/// ignored, recorded and signed. A file of the structure cannot hold them, so a session that has
/// any is kept as one with edits is.
inline constexpr std::array keptWork = {"ignored_findings", "answered_doubts", "choices", "seal"};

[[nodiscard]] inline bool hasKeptWork(const Project& project) {
  for (const char* name : keptWork)
    if (!project.document(name).empty()) return true;
  return false;
}

} // namespace espalier
