#pragma once

#include <QString>

class QAction;
class QToolButton;
class QWidget;

namespace espalier {

/// A button of a panel that does an action.
/// @param text  in place of that of the menu, which is longer; empty: as the action shows itself
[[nodiscard]] QToolButton* panelButton(QAction& action, const QString& text = {});

/// The same, which shares the width of the panel with those beside it and never widens it.
[[nodiscard]] QToolButton* sharingButton(QAction& action, const QString& text = {});

/// The same, which begins with the key of the action, as answers begin with theirs.
[[nodiscard]] QToolButton* keyedButton(QAction& action);

/// What is about to be hidden or disabled hands its keys on: by itself they would go to the next
/// part of the window, maybe in another panel, and Space would act there.
void passFocus(const QWidget& from, QWidget& to);

} // namespace espalier
