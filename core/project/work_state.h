#pragma once

#include "core/project/project.h"
#include "core/project/seal.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace espalier {

/// How far the work on a plant has come.
enum class WorkStage : std::uint8_t {
  toDo,      // there is no skeleton
  automatic, // there is one, with no correction by hand and no mark of the review
  inReview,  // there are some, or a seal that does not hold
  finished   // it is signed, and the seal holds
};

/// What a list of plants shows of a project.
struct WorkState {
  WorkStage stage = WorkStage::toDo;
  std::size_t nodes = 0;
  std::optional<std::size_t> openFindings = {}; // as signed, or as last known; none: never known
  std::int64_t time = 0;                        // [ms] at work, as handWork()
  std::string annotator = {};    // who signed, else who made most of the steps since the last
                                 // reconstruction; or none
  std::optional<Seal> seal = {}; // whether it holds or not
  std::optional<ScanReference> scan = {};
};

/// Name of the text of a project that says how many findings were open when checks ended last.
inline constexpr const char* openFindingsName = "open_findings";

/// What `project` says of the work on its plant; a seal that cannot be read counts as none. Reads
/// neither scan nor pieces of bytes. Time O(changes of the steps that are done).
/// @param history  that of the project
[[nodiscard]] WorkState workState(const Project& project, const History& history);

} // namespace espalier
