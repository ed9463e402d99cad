#include "ui/dialogs/key_bindings.h"

#include <QAction>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

QString settingOf(const QAction& action) {
  return "keys/" + action.objectName();
}

} // namespace

KeyBindings::KeyBindings(QList<QAction*> actions, QStringList fixed, QSettings& settings,
                         QObject* parent)
    : QObject(parent), actions_(std::move(actions)), fixed_(std::move(fixed)), settings_(settings) {
  for (QAction* action : actions_) {
    defaults_.insert(action, action->shortcuts());
    if (!settings_.contains(settingOf(*action)) || isFixed(*action)) continue;
    const QString text = settings_.value(settingOf(*action)).toString();
    action->setShortcuts(QKeySequence::listFromString(text, QKeySequence::PortableText));
  }
}

bool KeyBindings::isFixed(const QAction& action) const {
  return fixed_.contains(action.objectName());
}

bool KeyBindings::isChanged(const QAction& action) const {
  return action.shortcuts() != defaults_.value(&action);
}

bool KeyBindings::isAnyChanged() const {
  return std::ranges::any_of(actions_, [this](const QAction* each) { return isChanged(*each); });
}

QAction* KeyBindings::holder(const QKeySequence& keys, const QAction& but) const {
  if (keys.isEmpty()) return nullptr;
  for (QAction* action : actions_)
    if (action != &but && action->shortcuts().contains(keys)) return action;
  return nullptr;
}

void KeyBindings::set(QAction& action, const QKeySequence& keys) {
  Q_ASSERT(!isFixed(action));
  takeFromOthers(keys, action);
  give(action, keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys});
  emit changed();
}

void KeyBindings::reset(QAction& action) {
  for (const QKeySequence& keys : defaults_.value(&action))
    takeFromOthers(keys, action);
  give(action, defaults_.value(&action));
  emit changed();
}

void KeyBindings::resetAll() {
  for (QAction* action : actions_)
    give(*action, defaults_.value(action));
  emit changed();
}

void KeyBindings::give(QAction& action, const QList<QKeySequence>& keys) {
  action.setShortcuts(keys);
  if (isChanged(action))
    settings_.setValue(settingOf(action),
                       QKeySequence::listToString(keys, QKeySequence::PortableText));
  else
    settings_.remove(settingOf(action));
}

/// A fixed action may share its keys: it is on when the other is off.
void KeyBindings::takeFromOthers(const QKeySequence& keys, const QAction& but) {
  for (QAction* other : actions_) {
    QList<QKeySequence> left = other->shortcuts();
    if (other != &but && !isFixed(*other) && left.removeAll(keys) > 0) give(*other, left);
  }
}

} // namespace espalier
