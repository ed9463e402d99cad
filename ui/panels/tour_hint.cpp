#include "ui/panels/tour_hint.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {

TourHint::TourHint(QWidget* parent)
    : QFrame(parent), title_(new QLabel(this)), text_(new QLabel(this)),
      next_(new QPushButton(this)) {
  setObjectName("tour_hint");
  title_->setProperty("role", "section");
  text_->setObjectName("tour_text");
  text_->setWordWrap(true);
  text_->setFixedWidth(260);
  next_->setObjectName("tour_next");
  auto* leave = new QPushButton(tr("Leave the Tour"), this);
  leave->setObjectName("tour_leave");
  leave->setFlat(true);
  for (QPushButton* button : {next_, leave})
    button->setFocusPolicy(Qt::NoFocus); // the keys stay those of the plant
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(leave);
  buttons->addStretch();
  buttons->addWidget(next_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 12, 16, 12);
  column->setSpacing(8);
  column->addWidget(title_);
  column->addWidget(text_);
  column->addLayout(buttons);
  connect(next_, &QPushButton::clicked, this, &TourHint::nextAsked);
  connect(leave, &QPushButton::clicked, this, &TourHint::leaveAsked);
  parent->installEventFilter(this);
  hide();
}

void TourHint::showText(const QString& title, const QString& text, const QString& next,
                        QWidget* beside) {
  title_->setText(title);
  text_->setText(text);
  next_->setText(next);
  beside_ = beside;
  show();
  place();
  QTimer::singleShot(0, this, &TourHint::place); // what it stands beside may be laid out by then
}

QString TourHint::text() const {
  return text_->text();
}

bool TourHint::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return false;
}

void TourHint::place() {
  adjustSize();
  raise();
  constexpr int apart = 12; // [px]
  const QWidget& parent = *parentWidget();
  QRect at(QPoint(apart, apart), size());
  if (beside_ != nullptr && beside_->isVisible()) {
    const QRect meant(beside_->mapTo(&parent, QPoint()), beside_->size());
    const bool isLeft = meant.center().x() < parent.width() / 2;
    at.moveLeft(isLeft ? meant.right() + apart : meant.left() - width() - apart);
    at.moveTop(meant.center().y() - height() / 2);
  }
  at.moveLeft(std::clamp(at.left(), 0, std::max(0, parent.width() - width())));
  // Neither over the menus nor over the hints in the status line, of which it speaks.
  const auto* window = qobject_cast<const QMainWindow*>(&parent);
  const QWidget& room =
      window != nullptr && window->centralWidget() != nullptr ? *window->centralWidget() : parent;
  const int top = &room == &parent ? 0 : room.mapTo(&parent, QPoint()).y();
  at.moveTop(std::clamp(at.top(), top, std::max(top, top + room.height() - height())));
  setGeometry(at);
}

} // namespace espalier
