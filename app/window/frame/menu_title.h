#pragma once

class QAction;
class QMenu;
class QString;

namespace espalier {

/// Adds a line that names what follows. A section of a menu that has a style sheet shows no text.
QAction* addTitle(QMenu& menu, const QString& text);

} // namespace espalier
