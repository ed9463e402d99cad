#pragma once

#include "ui/document/plant_document.h"

#include <QUndoStack>

namespace espalier {

/// The last step that is done and not undone; 0: none.
[[nodiscard]] inline StepId lastStepOf(PlantDocument& document) {
  const int index = document.undoStack().index();
  return index > 0 ? document.step(index - 1).id : StepId{};
}

} // namespace espalier
