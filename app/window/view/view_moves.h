#pragma once

#include "app/window/frame/window_part.h"

namespace espalier {

class ActionSet;
class Editing;

/// Turns, moves and zooms the view that the pointer was in last by keys, a step each.
class ViewMoves : public WindowPart {
  Q_OBJECT

public:
  /// Both must outlive it.
  ViewMoves(ActionSet& actions, Editing& editing);
};

} // namespace espalier
