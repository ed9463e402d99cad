#include "ui/panels/message_banner.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>

#include <algorithm>
#include <utility>

namespace espalier {

MessageBanner::MessageBanner(QWidget* parent)
    : QFrame(parent), text_(new QLabel(this)), action_(new QPushButton(this)) {
  setObjectName("message_banner");
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* dismiss = new QPushButton(tr("Dismiss"), this);
  dismiss->setObjectName("dismiss");
  for (QPushButton* button : {action_, dismiss}) {
    button->setFlat(true);
    button->setCursor(Qt::PointingHandCursor);
  }
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 4, 8, 4);
  row->setSpacing(8);
  row->addWidget(text_, 1);
  row->addWidget(action_);
  row->addWidget(dismiss);
  leaves_.setSingleShot(true);
  leaves_.setInterval(10'000); // [ms], time to read it and to reach for Undo
  connect(&leaves_, &QTimer::timeout, this, &QWidget::hide);
  connect(dismiss, &QPushButton::clicked, this, &QWidget::hide);
  connect(action_, &QPushButton::clicked, this, [this] {
    hide();
    if (act_) act_();
  });
  parent->installEventFilter(this);
  hide();
}

void MessageBanner::showError(const QString& text) {
  act_ = nullptr;
  action_->hide();
  showText("error", text);
  leaves_.stop();
}

void MessageBanner::showResult(const QString& text, const QString& action,
                               std::function<void()> act) {
  act_ = std::move(act);
  action_->setText(action);
  action_->setVisible(!action.isEmpty());
  showText("result", text);
  leaves_.start();
}

QString MessageBanner::text() const {
  return text_->text();
}

bool MessageBanner::isError() const {
  return property("kind") == "error";
}

void MessageBanner::showText(const QString& kind, const QString& text) {
  text_->setText(text);
  setProperty("kind", kind); // the style sheet colors by it
  style()->unpolish(this);
  style()->polish(this);
  place();
  show();
  raise();
}

bool MessageBanner::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QFrame::eventFilter(watched, event);
}

void MessageBanner::place() {
  constexpr int margin = 12;
  constexpr int widest = 880;
  const int most = std::min(widest, parentWidget()->width() - 2 * margin);
  text_->setWordWrap(false);
  layout()->activate();
  QSize size = sizeHint();
  if (size.width() > most) {
    text_->setWordWrap(true);
    layout()->activate();
    size = {most, heightForWidth(most)};
  }
  setGeometry((parentWidget()->width() - size.width()) / 2,
              parentWidget()->height() - size.height() - margin, size.width(), size.height());
}

} // namespace espalier
