#pragma once

#include <QString>

class QWidget;

namespace espalier {

/// Says which part of the manual a panel or dialog is described in: a chapter, and a heading there
/// where it is not all of it, as "correct.md#selecting". F1 opens it.
void setManualPlace(QWidget& widget, const QString& place);

/// That of the widget, or of the nearest around it that says one; empty: none does.
[[nodiscard]] QString manualPlaceOf(const QWidget* widget);

} // namespace espalier
