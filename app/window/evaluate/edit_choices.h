#pragma once

#include "core/evaluate/match/edit_comparison.h"

#include <QObject>

class QActionGroup;
class QMenu;

namespace espalier {

class ActionSet;

/// The actions that choose what the edit distance of a comparison counts: as --edit-unit,
/// --edit-cost and --merge-paths do on the command line.
class EditChoices : public QObject {
  Q_OBJECT

public:
  explicit EditChoices(ActionSet& actions); // which outlives it

  [[nodiscard]] const EditOptions& options() const { return options_; }
  void set(const EditOptions& options); // without a signal
  void fillMenu(QMenu& menu) const;

signals:
  void chosen();

private:
  void addUnits();
  void addCosts();
  void choose(const EditOptions& options);
  void check();

  ActionSet& actions_;
  EditOptions options_;
  QActionGroup* units_;
  QActionGroup* costs_;
};

} // namespace espalier
