#pragma once

class QScrollArea;

namespace espalier {

/// Keeps a scroll area as wide as what is in it needs: nothing is cut off at its right.
/// pre: it has its widget
void keepWideEnough(QScrollArea& area);

} // namespace espalier
