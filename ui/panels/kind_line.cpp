#include "ui/panels/kind_line.h"

#include "ui/panels/label_role.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace espalier {

KindLine::KindLine(QAction& take, QWidget* parent)
    : QWidget(parent), text_(makeLabel("kind_text", "quiet")) {
  setObjectName("kind_line");
  text_->setWordWrap(true);
  auto* button = new QPushButton(take.text(), this);
  button->setObjectName("kind_take");
  button->setToolTip(take.toolTip());
  connect(button, &QPushButton::clicked, &take, &QAction::trigger);
  connect(&take, &QAction::changed, button, [&take, button] {
    button->setVisible(take.isEnabled());
    button->setToolTip(take.toolTip());
  });
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 0, 12, 8);
  column->setSpacing(4);
  column->addWidget(text_);
  column->addWidget(button);
  hide();
}

void KindLine::show(const QString& text, const QString& details) {
  text_->setText(text);
  text_->setToolTip(details);
  setVisible(!text.isEmpty());
}

} // namespace espalier
