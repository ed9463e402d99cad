#include "ui/dialogs/command_palette.h"

#include "ui/document/manual_place.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPixmap>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace espalier {
namespace {

QString fullText(const QAction& action) {
  const QString own = action.property("inPalette").toString();
  const QString name = action.text().remove('&').remove(QChar(0x2026)).simplified();
  return CommandPalette::tr("%1: %2").arg(action.property("section").toString(),
                                          own.isEmpty() ? name : own);
}

/// What is named as it was typed comes before what does so, and all that before what cannot be done
/// now. None: neither named so nor visible.
std::optional<int> scoreOf(const QAction& action, const QString& typed) {
  constexpr int notNow = -1000;
  if (!action.isVisible()) return std::nullopt;
  const int base = action.isEnabled() ? 0 : notNow;
  const QString name = fullText(action);
  const int byName = CommandPalette::match(name, typed);
  if (byName > 0) return base + byName + 1;
  if (CommandPalette::match(name + ' ' + action.statusTip(), typed) == 0) return std::nullopt;
  return base + 1;
}

constexpr int keysRole = Qt::UserRole + 1;

/// Keys stand in a column of their own, at the right.
class PaletteRow final : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    painter->setPen(option.palette.color(QPalette::PlaceholderText));
    painter->drawText(option.rect.adjusted(0, 0, -12, 0), Qt::AlignRight | Qt::AlignVCenter,
                      index.data(keysRole).toString());
  }
};

bool movesChoice(int key) {
  return key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp ||
         key == Qt::Key_PageDown;
}

/// As it was typed, or in the singular: "errors" finds "Next Error".
QString wordIn(const QString& text, const QString& typed) {
  static const QRegularExpression plural(QStringLiteral("^.{2,}[^isu]s$"),
                                         QRegularExpression::CaseInsensitiveOption);
  return plural.match(typed).hasMatch() && !text.contains(typed, Qt::CaseInsensitive)
             ? typed.chopped(1)
             : typed;
}

} // namespace

CommandPalette::CommandPalette(const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent, Qt::Popup | Qt::FramelessWindowHint), actions_(actions),
      typed_(new QLineEdit(this)), list_(new QListWidget(this)) {
  setObjectName("command_palette");
  setManualPlace(*this, QStringLiteral("window.md#commands"));
  setAttribute(Qt::WA_DeleteOnClose);
  setFixedSize(520, 400);
  typed_->setPlaceholderText(tr("Type a command"));
  typed_->setAccessibleName(tr("Type a command"));
  typed_->installEventFilter(this);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setIconSize(QSize(18, 18));
  list_->setItemDelegate(new PaletteRow(list_));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(8);
  column->addWidget(typed_);
  column->addWidget(list_, 1);
  connect(typed_, &QLineEdit::textChanged, this, &CommandPalette::refill);
  connect(typed_, &QLineEdit::returnPressed, this, &CommandPalette::runChosen);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::runChosen);
  refill();
  typed_->setFocus();
}

int CommandPalette::match(const QString& text, const QString& typed) {
  int score = 1;
  for (const QString& each : typed.split(' ', Qt::SkipEmptyParts)) {
    const QString word = wordIn(text, each);
    if (!text.contains(word, Qt::CaseInsensitive)) return 0;
    const bool beginsWord = text.startsWith(word, Qt::CaseInsensitive) ||
                            text.contains(" " + word, Qt::CaseInsensitive);
    const int beginning = word == each ? 10 : 5; // as it was typed before a singular
    score += beginsWord ? beginning : 1;
  }
  const QString phrase = typed.simplified();
  if (phrase.contains(' ') && text.contains(phrase, Qt::CaseInsensitive)) score += 5;
  return score;
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && movesChoice(static_cast<QKeyEvent*>(event)->key())) {
    QCoreApplication::sendEvent(list_, event);
    return true;
  }
  return QDialog::eventFilter(watched, event);
}

void CommandPalette::refill() {
  std::vector<std::pair<int, QAction*>> found;
  for (QAction* action : actions_) {
    if (const auto score = scoreOf(*action, typed_->text())) found.emplace_back(*score, action);
  }
  std::ranges::stable_sort(found, std::greater<>(), &std::pair<int, QAction*>::first);
  list_->clear();
  QPixmap nothing(list_->iconSize());
  nothing.fill(Qt::transparent); // keeps the names in one column
  for (const auto& [score, action] : found) {
    auto* item = new QListWidgetItem(action->icon().isNull() ? QIcon(nothing) : action->icon(),
                                     fullText(*action), list_);
    item->setData(Qt::UserRole, QVariant::fromValue(action));
    item->setData(keysRole, action->shortcut().toString(QKeySequence::NativeText));
    item->setToolTip(action->statusTip());
    if (!action->isEnabled()) item->setFlags(Qt::NoItemFlags);
  }
  if (list_->count() == 0) { // none can be chosen
    auto* none = new QListWidgetItem(tr("No command has this name"), list_);
    none->setFlags(Qt::NoItemFlags);
    return;
  }
  if (found.front().second->isEnabled()) list_->setCurrentRow(0);
}

void CommandPalette::runChosen() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr) return;
  auto* action = item->data(Qt::UserRole).value<QAction*>();
  if (action == nullptr || !action->isEnabled()) return;
  close();
  QTimer::singleShot(0, action, &QAction::trigger); // once the palette is gone
}

} // namespace espalier
