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
  history_.leftOut = history_.leftOut ^ history_.steps[history_.position].points;
  history_.organs = history_.organs ^ history_.steps[history_.position].organs;
  return {.kept = history_.steps.size(), .added = {}, .position = history_.position};
}

EditsAtRandom::Act EditsAtRandom::redo() {
  history_.steps[history_.position].delta.apply(history_.skeleton);
  history_.leftOut = history_.leftOut ^ history_.steps[history_.position].points;
  history_.organs = history_.organs ^ history_.steps[history_.position].organs;
  ++history_.position;
  return {.kept = history_.steps.size(), .added = {}, .position = history_.position};
}

/// Seldom any, of a scan of 1000 points.
PointSet EditsAtRandom::pointsAtRandom() {
  if (random_.below(8) > 0) return {};
  std::vector<Eigen::Index> points;
  for (Eigen::Index i = 0; i < 1000; ++i)
    if (random_.below(4) == 0) points.push_back(i);
  return PointSet::of(points);
}

/// How those set by hand change: seldom at all; at times some are not set any more.
OrganMarks EditsAtRandom::organsAtRandom() {
  const PointSet points = pointsAtRandom();
  if (points.isEmpty()) return {};
  std::optional<Organ> organ;
  if (const std::size_t drawn = random_.below(allOrgans.size() + 1); drawn < allOrgans.size())
    organ = allOrgans[drawn];
  return history_.organs.with(points, organ) ^ history_.organs;
}

/// Seldom another; at times none.
std::optional<EnvelopeChange> EditsAtRandom::envelopeAtRandom() {
  if (random_.below(5) > 0) return std::nullopt;
  const std::string before = envelopeAfter(history_).value_or("");
  return EnvelopeChange{
      .before = before,
      .after = random_.below(3) == 0 ? "" : "envelope " + std::to_string(random_.below(1000))};
}

EditsAtRandom::Act EditsAtRandom::edit(bool isDrag) {
  SkeletonEditor editor(history_.skeleton);
  const PointSet points = pointsAtRandom();
  history_.leftOut = history_.leftOut ^ points;
  const OrganMarks organs = organsAtRandom();
  history_.organs = history_.organs ^ organs;
  const std::size_t changes = points.isEmpty() ? 1 + random_.below(4) : 0;
  for (std::size_t i = 0; i < changes; ++i)
    editAtRandom(editor, random_);
  HistoryStep step{.id = StepId{random_.below(1'000'000'000)},
                   .text = "Edit " + std::to_string(random_.below(1000)),
                   .author = "Anna",
                   .time = static_cast<std::int64_t>(random_.below(1'000'000)),
                   .delta = editor.commit(),
                   .points = points,
                   .replacesContracted = random_.below(10) == 0,
                   .envelope = envelopeAtRandom(),
                   .organs = organs};
  history_.steps.resize(history_.position);
  if (isDrag) {
    step.delta = history_.steps.back().delta.then(step.delta);
    step.points = history_.steps.back().points ^ step.points;
    step.envelope = history_.steps.back().envelope;
    step.organs = history_.steps.back().organs ^ step.organs;
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
