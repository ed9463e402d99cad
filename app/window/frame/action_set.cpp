#include "app/window/frame/action_set.h"

#include "app/window/frame/icon.h"
#include "core/base/error.h"
#include "ui/document/shown_message.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QWidget>

#include <utility>

namespace espalier {
namespace {

/// What is being typed counts, whether Enter was pressed or not.
void takeWhatIsTyped() {
  if (auto* number = qobject_cast<QAbstractSpinBox*>(QApplication::focusWidget()))
    number->interpretText();
  else if (auto* text = qobject_cast<QLineEdit*>(QApplication::focusWidget()))
    emit text->editingFinished();
}

/// A keyboard has two keys that are called Enter: a command with one of them takes both.
QList<QKeySequence> withBothEnters(const QKeySequence& keys) {
  if (keys.isEmpty()) return {};
  if (keys.count() != 1 || keys[0].key() != Qt::Key_Enter) return {keys};
  return {keys, QKeyCombination(keys[0].keyboardModifiers(), Qt::Key_Return)};
}

/// Its text, its keys and what it does, as they are now.
void refreshToolTip(QAction& action) {
  const QString text = action.text().remove('&').remove(QChar(0x2026)).toHtmlEscaped();
  const QString keys = action.shortcut().toString(QKeySequence::NativeText).toHtmlEscaped();
  action.setToolTip(QStringLiteral("<b>%1</b>%2<br>%3")
                        .arg(text, keys.isEmpty() ? "" : "&nbsp;&nbsp; " + keys,
                             action.statusTip().toHtmlEscaped()));
}

} // namespace

ActionSet::ActionSet(QWidget& window) : QObject(&window), window_(window) {}

QAction* ActionSet::add(const Command& command, std::function<void()> act) {
  auto* action = new QAction(command.text, this);
  action->setShortcuts(withBothEnters(command.keys));
  action->setCheckable(command.isCheckable);
  action->setStatusTip(command.help);
  const QString name = QString(command.text).remove('&').remove(QChar(0x2026));
  action->setProperty("name", name); // for lists: its text may name what it acts on now
  action->setProperty("inPalette", command.inPalette);
  refreshToolTip(*action);
  connect(action, &QAction::changed, action, [action] { refreshToolTip(*action); });
  if (act)
    connect(action, &QAction::triggered, this,
            [this, refusal = command.refusal, act = std::move(act)] {
              const auto done = [&] {
                takeWhatIsTyped();
                act();
                return true;
              };
              if (guarded(done, refusal)) emit acted();
            });
  if (!command.menu.isEmpty()) place(command.menu, QStringList{command.id});
  return adopt(command.id, action, command.icon);
}

QAction* ActionSet::adopt(const QString& id, QAction* action, const QString& icon) {
  action->setObjectName(id);
  action->setProperty("section", section_);
  if (!icon.isEmpty()) action->setIcon(themedIcon(icon));
  window_.addAction(action); // its keys work while no menu shows it
  all_.append(action);
  byId_.insert(id, action);
  return action;
}

void ActionSet::place(const QString& place, const QStringList& ids) {
  this->place(place, [this, ids](QMenu& menu) {
    for (const QString& id : ids)
      if (id.isEmpty())
        menu.addSeparator();
      else
        menu.addAction((*this)[id]);
  });
}

void ActionSet::place(const QString& place, std::function<void(QMenu&)> fill) {
  places_.emplace_back(place, std::move(fill));
}

void ActionSet::fill(QMenu& menu, const QString& place) const {
  for (const auto& [at, fill] : places_)
    if (at == place) fill(menu);
}

QAction* ActionSet::operator[](const QString& id) const {
  Q_ASSERT(byId_.contains(id));
  return byId_.value(id);
}

bool ActionSet::guarded(const std::function<bool()>& act, Refusal refusal, bool otherwise) {
  try {
    return act();
  } catch (const Error& error) {
    QString reason = shownText(error);
    if (refusal != Refusal::inBanner && !reason.isEmpty()) reason[0] = reason[0].toUpper();
    emit refused(reason, refusal);
    return otherwise;
  }
}

} // namespace espalier
