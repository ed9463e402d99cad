#include "ui/document/gesture.h"

namespace espalier {

Gesture Gesture::begin() {
  static int last = -1;
  Gesture gesture;
  gesture.id_ = ++last;
  return gesture;
}

} // namespace espalier
