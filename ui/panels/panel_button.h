#pragma once

#include <QString>

class QAction;
class QToolButton;

namespace espalier {

/// A button of a panel that does an action.
/// @param text  in place of that of the menu, which is longer; empty: as the action shows itself
[[nodiscard]] QToolButton* panelButton(QAction& action, const QString& text = {});

/// The same, which shares the width of the panel with those beside it and never widens it.
[[nodiscard]] QToolButton* sharingButton(QAction& action, const QString& text = {});

} // namespace espalier
