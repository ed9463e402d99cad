#pragma once

#include "app/window/frame/window_part.h"
#include "core/project/history.h"

#include <QString>

#include <functional>
#include <vector>

namespace espalier {

class PlantDocument;

/// What was ignored and shown again, as steps that Undo and Redo pass through in their turn. They
/// are none of the plant, whose history knows nothing of them: each is kept beside the last step of
/// the plant that was done before it, until points are set aside, or another plant, scan or
/// reference is shown.
class IgnoringSteps : public WindowPart {
  Q_OBJECT

public:
  struct Step {
    QString text; // as Undo names it
    std::function<void()> undo;
    std::function<void()> redo;
  };
  explicit IgnoringSteps(PlantDocument& document);

  /// A step that is done already: what was undone before it is not made again.
  void add(Step step);
  /// Whether a step of these, and none of the plant, was done last, or is to be made again first.
  [[nodiscard]] bool canUndo() const { return isAtPlace(done_); }
  [[nodiscard]] bool canRedo() const { return isAtPlace(undone_); }
  [[nodiscard]] const QString& undoText() const { return done_.back().step.text; } // pre: canUndo()
  [[nodiscard]] const QString& redoText() const {
    return undone_.back().step.text;
  }              // pre: canRedo()
  void undo();   // likewise
  void redo();   // likewise
  void forget(); // Undo comes to none of them any more

signals:
  void changed();

private:
  struct Placed {
    StepId after; // of the plant
    Step step;
  };
  [[nodiscard]] bool isAtPlace(const std::vector<Placed>& steps) const;
  void follow(int index); // of the undo stack

  PlantDocument& document_;
  std::vector<Placed> done_;
  std::vector<Placed> undone_;
  int index_ = 0;
  StepId next_ = {}; // the step of the plant that Redo would do
};

} // namespace espalier
