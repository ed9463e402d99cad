#include "tests/core/project/edits_at_random.h"

#include "tests/support/random_edits.h"

#include <string>

namespace espalier::test {
EditsAtRandom::Act EditsAtRandom::next() {
  const std::size_t kind = random_.below(10);
  if (kind < 2 && history_.position > 0) return undo();
  if (kind < 4 && history_.position < history_.steps.size()) return redo();
  return edit(kind == 4 && history_.position > 0);
}

EditsAtRandom::Act EditsAtRandom::undo() {
  --history_.position;
  history_.steps[history_.position].delta.inverse().apply(history_.skeleton);
  return {.kept = history_.steps.size(), .added = {}, .position = history_.position};
}

EditsAtRandom::Act EditsAtRandom::redo() {
  history_.steps[history_.position].delta.apply(history_.skeleton);
  ++history_.position;
  return {.kept = history_.steps.size(), .added = {}, .position = history_.position};
}

EditsAtRandom::Act EditsAtRandom::edit(bool isDrag) {
  SkeletonEditor editor(history_.skeleton);
  const std::size_t changes = 1 + random_.below(4);
  for (std::size_t i = 0; i < changes; ++i)
    editAtRandom(editor, random_);
  HistoryStep step{.text = "Edit " + std::to_string(random_.below(1000)),
                   .author = "Anna",
                   .time = static_cast<std::int64_t>(random_.below(1'000'000)),
                   .delta = editor.commit()};
  history_.steps.resize(history_.position);
  if (isDrag) {
    step.delta = history_.steps.back().delta.then(step.delta);
    history_.steps.pop_back();
  }
  const std::size_t kept = history_.steps.size();
  history_.steps.push_back(std::move(step));
  history_.position = history_.steps.size();
  return {.kept = kept,
          .added = std::span(history_.steps).subspan(kept),
          .position = history_.position};
}

} // namespace espalier::test
