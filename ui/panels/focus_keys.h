#pragma once

#include <QWidget>

#include <functional>

class QAbstractItemView;
class QComboBox;

namespace espalier {

// Keys that a widget has for itself while it has the focus; elsewhere they do what the action with
// this key does.

/// Lets Enter, alone, do `act`. With Ctrl and its like it stays that of the actions.
void onEnter(QWidget& widget, std::function<void()> act);

/// The same for a list of choices: Enter opens it; once it is open, all keys choose in it.
void opensOnEnter(QComboBox& choices);

/// Lets Home, End, Page Up and Page Down go through the rows. That the keyboard comes to the list
/// makes no row current: the arrows lead from the one that is, or to the first.
void goesThroughRows(QAbstractItemView& list);

/// Lets Escape, alone, do `act`.
void onEscape(QWidget& widget, std::function<void()> act);

/// Lets the key for copying do `act`.
void onCopy(QWidget& widget, std::function<void()> act);

} // namespace espalier
