#pragma once

#include "app/window/frame/window_part.h"

#include <functional>
#include <optional>

namespace espalier {

class ActionSet;
class AskingFlow;
class Editing;
class IgnoringSteps;
class PlantDocument;
class PreviewFlow;
class ProjectFlow;
class RegistrationFlow;
class ShownFlow;
struct SkeletonDelta;

/// What is edited by no tool: undo and redo, all that can be selected, and Escape.
class EditFlow : public WindowPart {
  Q_OBJECT

public:
  EditFlow(PlantDocument& document, ActionSet& actions);

  /// Parts that are made later, and must be before any command is given.
  struct Later {
    Editing& editing;
    PreviewFlow& preview;
    const ShownFlow& shown;
    const ProjectFlow& projects;
    RegistrationFlow& registration;
    AskingFlow& asking;
    IgnoringSteps& ignoring;
    std::function<bool()> dismissesMessage; // that waits for an answer
  };
  void join(const Later& later);

private:
  void addHistory();
  void refreshHistory();
  void undo();
  void redo();
  void leave();
  [[nodiscard]] bool endsPreview(int step) const; // of the undo stack: no more than that
  void noteStep(int index);
  void selectWhereUndone(const SkeletonDelta& undone);

  PlantDocument& document_;
  ActionSet& actions_;
  std::optional<Later> later_;
  int step_ = 0; // of the undo stack, when it was noted last
};

} // namespace espalier
