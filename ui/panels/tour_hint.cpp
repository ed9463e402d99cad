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
namespace {

/// Null: it has none.
QWidget* viewOf(const QWidget& window) {
  const auto* main = qobject_cast<const QMainWindow*>(&window);
  return main != nullptr ? main->centralWidget() : nullptr;
}

} // namespace

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
  if (QWidget* view = viewOf(*parentWidget())) view->installEventFilter(this); // once
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
  // Over the view: not over menus, forms, and hints in the status line, of which it speaks.
  const QWidget* view = viewOf(parent);
  const QRect room = view != nullptr ? view->geometry() : parent.rect();
  QRect at(QPoint(), size());
  at.moveCenter(room.center());
  at.moveRight(room.right() - apart); // where what it is meant for is behind other tabs
  if (beside_ != nullptr && beside_->isVisible()) {
    const QRect meant(beside_->mapTo(&parent, QPoint()), beside_->size());
    const bool isLeft = meant.center().x() < parent.width() / 2;
    at.moveLeft(isLeft ? meant.right() + apart : meant.left() - width() - apart);
    at.moveTop(meant.center().y() - height() / 2);
  }
  at.moveLeft(std::clamp(at.left(), room.left(), std::max(room.left(), room.right() - width())));
  at.moveTop(std::clamp(at.top(), room.top(), std::max(room.top(), room.bottom() - height())));
  setGeometry(at);
}

} // namespace espalier
