#pragma once

#include <QWidget>

#include <functional>

namespace espalier {

/// Lets the key for copying do `act` while a widget has the focus; elsewhere it copies nodes.
void onCopy(QWidget& widget, std::function<void()> act);

} // namespace espalier
