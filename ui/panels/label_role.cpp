#include "ui/panels/label_role.h"

#include <QLabel>
#include <QStyle>

namespace espalier {

QLabel* makeLabel(const char* name, const char* role) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setProperty("role", role);
  return label;
}

void setRole(QWidget& widget, const char* role) {
  widget.setProperty("role", role);
  widget.style()->polish(&widget);
}

} // namespace espalier
