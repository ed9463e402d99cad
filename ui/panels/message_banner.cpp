#include "ui/panels/message_banner.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyle>

#include <algorithm>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// Reasons begin with a small letter or with the name of a file, which stays as it is.
QString asSentence(QString reason) {
  static const QRegularExpression name(QStringLiteral("^\\S*[.,:]"));
  if (!reason.isEmpty() && !name.match(reason).hasMatch()) reason[0] = reason[0].toUpper();
  return reason;
}

} // namespace

MessageBanner::MessageBanner(QWidget* parent)
    : QFrame(parent), row_(new QBoxLayout(QBoxLayout::LeftToRight, this)),
      text_(new QLabel(this)), buttons_{new QPushButton(this), new QPushButton(this)} {
  setObjectName("message_banner");
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* dismiss = new QPushButton(tr("Dismiss"), this);
  dismiss->setObjectName("dismiss");
  buttons_[0]->setObjectName("banner_action");
  buttons_[1]->setObjectName("banner_other_action");
  for (QPushButton* button : {buttons_[0], buttons_[1], dismiss}) {
    button->setFlat(true);
    button->setCursor(Qt::PointingHandCursor);
  }
  row_->setContentsMargins(16, 4, 8, 4);
  row_->setSpacing(4);
  row_->addWidget(text_, 1);
  auto* answers = new QHBoxLayout;
  answers->setSpacing(8);
  answers->addStretch();
  for (QPushButton* button : buttons_)
    answers->addWidget(button);
  answers->addWidget(dismiss);
  row_->addLayout(answers);
  leaves_.setSingleShot(true);
  leaves_.setInterval(10'000); // [ms], time to read it and to reach for Undo
  connect(&leaves_, &QTimer::timeout, this, &QWidget::hide);
  connect(dismiss, &QPushButton::clicked, this, &QWidget::hide);
  parent->installEventFilter(this);
  for (std::size_t i = 0; i < buttons_.size(); ++i)
    connect(buttons_[i], &QPushButton::clicked, this, [this, i] {
      hide();
      const std::function<void()> act = actions_[i].act; // it may show the next message
      if (act) act();
    });
  hide();
}

void MessageBanner::showError(const QString& text, const Actions& actions) {
  showText("error", asSentence(text), actions);
  leaves_.stop();
}

void MessageBanner::showOffer(const QString& text, const Actions& actions) {
  showText("result", text, actions);
  leaves_.stop();
}

void MessageBanner::showResult(const QString& text, const QString& action,
                               std::function<void()> act) {
  showText("result", text, action.isEmpty() ? Actions() : Actions{{action, std::move(act)}});
  leaves_.start();
}

bool MessageBanner::dismiss() {
  if (!isVisible() || leavesByItself()) return false;
  hide();
  return true;
}

QString MessageBanner::text() const {
  return text_->text();
}

bool MessageBanner::isError() const {
  return property("kind") == "error";
}

void MessageBanner::showText(const QString& kind, const QString& text, const Actions& actions) {
  actions_ = actions;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i]->setVisible(i < actions_.size());
    if (i < actions_.size()) buttons_[i]->setText(actions_[i].text);
  }
  text_->setText(text);
  setProperty("kind", kind); // the style sheet colors by it
  style()->unpolish(this);
  style()->polish(this);
  place();
  show();
  raise();
  emit shown(text);
}

bool MessageBanner::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && !isHidden()) place();
  return QFrame::eventFilter(watched, event);
}

QSize MessageBanner::sizeWithin(int width) {
  text_->setWordWrap(false);
  for (const auto direction : {QBoxLayout::LeftToRight, QBoxLayout::TopToBottom}) {
    row_->setDirection(direction);
    row_->activate();
    if (const QSize size = sizeHint(); size.width() <= width) return size;
  }
  text_->setWordWrap(true);
  row_->activate();
  const int least = std::max(width, row_->minimumSize().width()); // no button is cut
  return {least, heightForWidth(least)};
}

void MessageBanner::place() {
  constexpr int margin = 12;
  constexpr int widest = 880;
  constexpr int scaleBar = 40; // [pixels] above the foot, at the left
  constexpr int axes = 88;     // likewise, at the right
  const QRect within = parentWidget()->rect().adjusted(margin, margin, -margin, -margin);
  const QSize wide = sizeWithin(std::min(widest, within.width()));
  const QSize high = sizeWithin(wide.width() - 1); // its buttons below its line
  const auto wrapped = [&](int width) { return sizeWithin(std::min(width, within.width())); };
  const auto at = [&](const QSize& size, double across, int top) {
    return QRect(within.left() + int(across * (within.width() - size.width())), top, size.width(),
                 size.height());
  };
  const auto foot = [&](const QSize& size) { return within.bottom() + 1 - size.height(); };
  std::vector<QRect> places = {at(wide, 0.5, foot(wide))};
  for (const QSize& size : {wide, high, wrapped(400), wrapped(300)})
    for (const QRect& place :
         {at(size, 0, foot(size) - scaleBar), at(size, 1, foot(size) - axes),
          at(size, 0, within.top()), at(size, 1, within.top()), at(size, 0.5, within.top())})
      places.push_back(place);
  QRect best = places.front();
  int least = covered_ ? covered_(best) : 0;
  for (const QRect& place : places) {
    if (least == 0) break;
    const int covered = covered_(place);
    if (covered < least) best = place;
    least = std::min(least, covered);
  }
  static_cast<void>(sizeWithin(best.width())); // its text is as wide as that
  setGeometry(best);
}

} // namespace espalier
