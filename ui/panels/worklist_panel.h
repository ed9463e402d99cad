#pragma once

#include "ui/panels/worklist_model.h"

#include <QStringList>
#include <QWidget>

class QAction;
class QComboBox;
class QLabel;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;

namespace espalier {

/// The plants of a worklist, sorted by any column and filtered by their state.
class WorklistPanel : public QWidget {
  Q_OBJECT

public:
  struct Actions {
    QAction* folder; // chooses one
    QAction* table;  // likewise
    QAction* next;
  };
  explicit WorklistPanel(const Actions& actions, QWidget* parent = nullptr);

  /// @param place    of the list, for people; empty: there is none
  /// @param problem  why it cannot be read; empty: it can
  /// @param areInOrder  as they stand in a table; else they are sorted by their names
  void show(const QString& place, const QString& problem, std::vector<ListedPlant> plants,
            const QStringList& others, bool areInOrder = false);
  void setOpen(const QString& file); // the plant that is open; empty: none of them

  /// The plants behind that file, in the order and of those that are shown, that are not signed and
  /// can be opened; from the top again at the end, without itself. Those that are still read do not
  /// count.
  [[nodiscard]] std::vector<WorklistRow> following(const QString& file) const;
  [[nodiscard]] bool isReading() const; // whether some are still read

signals:
  void chosen(const QString& file); // to open; empty: the row has none

private:
  void makeList();
  void choose();
  void refreshTexts();
  void showOpen(); // once, when its row is there

  WorklistModel* model_;
  QSortFilterProxyModel* shown_;
  bool areInOrder_ = false; // as it was shown last
  QLabel* title_;
  QLabel* note_;
  QComboBox* filter_;
  QToolButton* next_;
  QTableView* list_;
  QString place_;
  QString problem_;
  QString open_;
  bool isOpenShown_ = true;
};

} // namespace espalier
