#pragma once

#include "core/evaluate/differences/differences.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QAction;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;
class QToolButton;

namespace espalier {

class PlantDocument;

/// The list of what differs between a plant and its reference, longest first unless sorted
/// otherwise, and of what of it is ignored.
class DifferencesPanel : public QWidget {
  Q_OBJECT

public:
  /// What its buttons do; the actions outlive it.
  struct Actions {
    QAction* previous;
    QAction* next;
    QAction* accept;
    QAction* ignore;
  };
  DifferencesPanel(const PlantDocument& document, const Actions& actions,
                   QWidget* parent = nullptr);

  /// @param tolerance [L], within which parts before and after are the same
  void show(const std::vector<DifferingPart>& parts, const std::vector<DifferingPart>& ignored,
            double tolerance);
  [[nodiscard]] bool isEmpty() const { return count_ == 0; } // but for what is ignored
  [[nodiscard]] std::optional<DifferingPart> current() const;
  /// Goes on in the list as it is sorted, without what is ignored; from the end to the beginning.
  /// Where the present one is gone, on to what follows it. None: there is nothing.
  std::optional<DifferingPart> step(int by);

signals:
  void chosen(const espalier::DifferingPart& part); // by a click, Enter, or a key that goes there
  void currentChanged();

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  bool eventFilter(QObject* watched, QEvent* event) override; // of the list
  void addItem(const DifferingPart& part, bool isIgnored);
  void restoreCurrent(const std::optional<DifferingPart>& part, double tolerance);
  void refreshTitle();
  void endBetweenRows();
  void reportChosen(const QTreeWidgetItem* item);

  const PlantDocument& document_;
  std::vector<DifferingPart> listed_; // by the number that its item keeps
  std::size_t count_ = 0;             // without those that are ignored
  std::size_t ignored_ = 0;
  int gone_ = -1; // where what was the present one stood; -1: it is there, or there was none
  QLabel* title_;
  QToolButton* showIgnored_;
  QTreeWidget* list_;
};

} // namespace espalier
