#pragma once

#include <QWidget>

#include <functional>

class QComboBox;

namespace espalier {

/// Lets Enter, alone, do `act` while a widget has the focus; elsewhere it does what the action with
/// this key does. With Ctrl and its like it stays that of the actions.
void onEnter(QWidget& widget, std::function<void()> act);

/// The same for a list of choices: Enter opens it.
void opensOnEnter(QComboBox& choices);

} // namespace espalier
