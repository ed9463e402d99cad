#pragma once

#include "core/skeleton/finding.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QAction;
class QLabel;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace espalier {

class CheckForm;
class PlantDocument;

/// The list of what is worth a second look, grouped by kind, and of what is ignored.
class FindingsPanel : public QWidget {
  Q_OBJECT

public:
  /// What its buttons do; the actions outlive it.
  struct Actions {
    QAction* previous;
    QAction* next;
    QAction* ignore;
  };
  FindingsPanel(const PlantDocument& document, const Actions& actions, QWidget* parent = nullptr);

  /// pre: the skeleton has the nodes of the findings
  void show(const std::vector<Finding>& findings, const std::vector<Finding>& ignored);
  void setChecking(bool isChecking);                           // the scan: more may follow
  [[nodiscard]] CheckForm& checks() const { return *checks_; } // from where on they report
  void setCurrent(const Finding& finding);
  void showSentence(const QString& text);               // of the current one; empty: none
  [[nodiscard]] std::optional<Finding> current() const; // of either list

signals:
  void chosen(const espalier::Finding& finding); // by a click or Enter
  void currentChanged();

private:
  void addGroup(const QString& title, const std::vector<Finding>& findings, bool isOpen,
                bool isIgnored);
  void refreshTexts();
  void restoreCurrent(const std::optional<Finding>& finding);
  void reportChosen(const QTreeWidgetItem* item);
  [[nodiscard]] QString textOf(const Finding& finding) const;

  const PlantDocument& document_;
  std::vector<Finding> listed_; // by the number that its item keeps
  std::size_t count_ = 0;       // without those that are ignored
  bool isChecking_ = false;
  QLabel* title_;
  QLabel* note_;
  QLabel* sentence_; // what the current one is, and what can be done
  QTreeWidget* list_;
  QWidget* walk_; // from finding to finding; absent where there is none
  QToolButton* ignore_ = nullptr;
  CheckForm* checks_;
};

} // namespace espalier
