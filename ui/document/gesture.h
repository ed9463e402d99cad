#pragma once

namespace espalier {

/// One press, drag and release. Its edits become one undo step.
class Gesture {
public:
  Gesture() = default; // no gesture: an edit of its own

  /// A gesture that differs from all before it. GUI thread only.
  [[nodiscard]] static Gesture begin();

  [[nodiscard]] bool isNone() const { return id_ < 0; }
  [[nodiscard]] int id() const { return id_; } // as in QUndoCommand::id: -1 merges with nothing
  bool operator==(const Gesture&) const = default;

private:
  int id_ = -1;
};

} // namespace espalier
