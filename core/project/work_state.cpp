#include "core/project/work_state.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/corrections.h"
#include "core/project/structure_hash.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace espalier {
namespace {

std::optional<Seal> sealOf(const Project& project) {
  const std::string text = project.document("seal");
  if (text.empty()) return std::nullopt;
  try {
    return sealFrom(text);
  } catch (const Error&) { // the window says so when it opens the project
    return std::nullopt;
  }
}

/// @param seal  that holds; none: there is none
std::optional<std::size_t> openFindingsIn(const Project& project, const Seal* seal) {
  if (seal != nullptr && seal->state) return seal->state->openFindings();
  const std::optional<double> known = numberIn(project.document(openFindingsName));
  constexpr double most = 1e9; // no plant has as many
  if (!known || !(*known >= 0 && *known < most)) return std::nullopt;
  return static_cast<std::size_t>(*known);
}

bool hasMarks(const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids();
  return std::ranges::any_of(ids, [&](NodeId id) {
    const ReviewMark& mark = skeleton[id].review;
    return mark.state != ReviewState::toDo || !mark.comment.empty();
  });
}

/// Who made most of these steps, of several the one who came last: a reviewer who mends a node does
/// not take a plant over. Empty: there is none.
std::string mostlyBy(std::span<const HistoryStep> steps) {
  std::map<std::string_view, std::size_t> counts;
  for (const HistoryStep& step : steps)
    ++counts[step.author];
  std::size_t most = 0;
  for (const auto& [author, count] : counts)
    most = std::max(most, count);
  const auto last = std::find_if(steps.rbegin(), steps.rend(), [&](const HistoryStep& step) {
    return counts[step.author] == most;
  });
  return last == steps.rend() ? std::string() : last->author;
}

} // namespace

WorkState workState(const Project& project, const History& history) {
  const auto done = std::span(history.steps).first(history.position);
  const HandWork work = handWork(done, history.skeleton);
  WorkState state{.nodes = history.skeleton.size(),
                  .time = work.time,
                  .annotator = mostlyBy(done),
                  .seal = sealOf(project),
                  .scan = project.scan()};
  const bool isSigned = state.seal && state.seal->hash == StructureHash(history.skeleton).value();
  state.openFindings = openFindingsIn(project, isSigned ? &*state.seal : nullptr);
  if (isSigned) state.annotator = state.seal->author;
  if (history.skeleton.isEmpty())
    state.stage = WorkStage::toDo;
  else if (isSigned)
    state.stage = WorkStage::finished;
  else if (state.seal || work.corrections.edits > 0 || hasMarks(history.skeleton))
    state.stage = WorkStage::inReview;
  else
    state.stage = WorkStage::automatic;
  return state;
}

} // namespace espalier
