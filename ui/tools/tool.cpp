#include "ui/tools/tool.h"

namespace espalier {

bool Tool::handle(const ToolInput& input) {
  if (input.phase == ToolInput::Phase::cancel) {
    const bool wasBusy = isBusy();
    cancel();
    emit hintChanged();
    return wasBusy;
  }
  under_ = input.pick;
  const bool taken = act(input);
  emit hintChanged();
  return taken;
}

} // namespace espalier
