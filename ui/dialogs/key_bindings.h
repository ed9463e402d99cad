#pragma once

#include <QHash>
#include <QKeySequence>
#include <QList>
#include <QObject>

class QAction;
class QSettings;

namespace espalier {

/// The keys of actions as the user wants them, kept in the settings. No two actions share one.
class KeyBindings : public QObject {
  Q_OBJECT

public:
  /// The keys that actions have now are their defaults; they get those of the settings.
  /// @param actions   each with an object name of its own, which the settings know it by
  /// @param fixed     names of those whose keys stay as they are
  /// @param settings  must outlive it
  KeyBindings(QList<QAction*> actions, QStringList fixed, QSettings& settings, QObject* parent);

  [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }
  [[nodiscard]] bool isFixed(const QAction& action) const;
  [[nodiscard]] bool isChanged(const QAction& action) const;
  [[nodiscard]] bool isAnyChanged() const;

  /// Another action that has these keys; null: none.
  [[nodiscard]] QAction* holder(const QKeySequence& keys, const QAction& but) const;

  /// Gives an action these keys alone, and takes them from any other. Empty: none.
  /// pre: the action is not fixed, and the holder of the keys is not
  void set(QAction& action, const QKeySequence& keys);
  /// Gives an action its default keys, and takes them from any other.
  void reset(QAction& action);
  void resetAll();

signals:
  void changed();

private:
  void give(QAction& action, const QList<QKeySequence>& keys);
  void takeFromOthers(const QKeySequence& keys, const QAction& but);

  QList<QAction*> actions_;
  QStringList fixed_;
  QSettings& settings_;
  QHash<const QAction*, QList<QKeySequence>> defaults_;
};

} // namespace espalier
