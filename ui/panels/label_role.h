#pragma once

class QLabel;
class QWidget;

namespace espalier {

/// A label that looks as its role: "title", "value", "quiet" or "warning".
[[nodiscard]] QLabel* makeLabel(const char* name, const char* role);
void setRole(QWidget& widget, const char* role);

} // namespace espalier
