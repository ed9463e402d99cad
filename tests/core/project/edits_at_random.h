#pragma once

#include "core/base/random.h"
#include "core/project/history.h"

#include <cstdint>
#include <span>

namespace espalier::test {

/// What a person might do to a plant, drawn at random: edits, points set aside and brought back,
/// drags, undo, redo, edits that drop what was undone. The same seed and the same beginning give
/// the same acts.
class EditsAtRandom {
public:
  EditsAtRandom(History beginning, std::uint64_t seed)
      : history_(std::move(beginning)), random_(seed) {}

  [[nodiscard]] const History& history() const { return history_; }

  /// A change of the history, as Project::record takes it.
  struct Act {
    std::size_t kept = 0;
    std::span<const HistoryStep> added;
    std::size_t position = 0;
  };
  [[nodiscard]] Act next(); // done in history() already; valid until the next one

private:
  [[nodiscard]] Act undo();
  [[nodiscard]] Act redo();
  [[nodiscard]] Act edit(bool isDrag);
  [[nodiscard]] PointSet pointsAtRandom();
  [[nodiscard]] OrganMarks organsAtRandom();
  [[nodiscard]] std::optional<EnvelopeChange> envelopeAtRandom();

  History history_;
  Random random_;
};

} // namespace espalier::test
