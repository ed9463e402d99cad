#pragma once

#include <QHash>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>

#include <functional>
#include <utility>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace espalier {

/// Where the reason is shown if a command is refused: at the pointer for what one does there, at
/// the field for what one types.
enum class Refusal { inBanner, atPointer, atField };

/// A command of the window, as it is listed once for menu, toolbar, palette and shortcut sheet.
struct Command {
  QString id; // never translated: settings and tests know it by this
  QString text;
  QString help;      // one line
  QString icon = {}; // name in resources/icons
  QKeySequence keys = {};
  bool isCheckable = false;
  Refusal refusal = Refusal::inBanner;
  QString menu = {};      // its place there, see menus.cpp; empty: in none, or its part places it
  QString inPalette = {}; // its text there, where a menu gives that of its group; empty: the same
};

/// All actions of the window, in sections, and their places in the menus. What an action throws as
/// an Error is reported as `refused`: this is where errors of commands are caught.
class ActionSet : public QObject {
  Q_OBJECT

public:
  explicit ActionSet(QWidget& window);

  /// Begins a section; actions added from now on belong to it.
  void beginSection(const QString& name) { section_ = name; }
  QAction* add(const Command& command, std::function<void()> act);
  /// Takes over an action that acts by itself.
  QAction* adopt(const QString& id, QAction* action, const QString& icon = {});

  /// Puts actions at a place in the menus, behind what is there already; an empty id is a line.
  void place(const QString& place, const QStringList& ids);
  /// Likewise, whatever `fill` puts there: once, but whenever it opens in a context menu.
  void place(const QString& place, std::function<void(QMenu&)> fill);
  /// Adds all that is at a place.
  void fill(QMenu& menu, const QString& place) const;

  [[nodiscard]] QAction* operator[](const QString& id) const; // pre: it was added
  [[nodiscard]] const QList<QAction*>& all() const { return all_; }

  /// Runs `act`, and reports an Error as `refused`. Returns what it returned, `otherwise` if
  /// refused.
  bool guarded(const std::function<bool()>& act, Refusal refusal, bool otherwise = false);

  /// Where the text stands that is typed, for Refusal::atField; null: nowhere, or it is gone.
  void setField(QWidget* field) { field_ = field; }
  [[nodiscard]] QWidget* field() const { return field_; }

signals:
  void refused(const QString& reason, espalier::Refusal where);
  void acted(); // a command was done

private:
  QWidget& window_;
  QString section_;
  QPointer<QWidget> field_;
  std::vector<std::pair<QString, std::function<void(QMenu&)>>> places_;
  QList<QAction*> all_;
  QHash<QString, QAction*> byId_;
};

} // namespace espalier
