#pragma once

#include "core/doubt/doubt.h"

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

class PlantDocument;

/// What the program is in doubt about, what answers are worth, and the doubt that is asked about,
/// with its answers.
class DoubtsPanel : public QWidget {
  Q_OBJECT

public:
  /// What its buttons do; the actions outlive it.
  struct Actions {
    QAction* ask;
    std::vector<QAction*> answers; // the first alternative, the second ...
    QAction* none;
    QAction* skip;
    QAction* takeBack;
    QAction* decideRest;
  };
  DoubtsPanel(const PlantDocument& document, const Actions& actions, QWidget* parent = nullptr);

  /// The doubts that are still to be asked, as many of them as a person looks at.
  void show(const std::vector<Doubt>& doubts, std::size_t all);
  /// @param text    how much is right; empty: it is not known
  /// @param isOfNow else it is of the plant before the last edits, and is grey
  void showAgreement(const QString& text, bool isOfNow);
  void showNote(const QString& text); // why there are none, or that they are looked for
  /// @param doubt    that is asked about; none: nothing is
  /// @param isByHand no alternative was right: it is corrected with a tool
  void setCurrent(const std::optional<Doubt>& doubt, bool isByHand);

signals:
  void chosen(const espalier::Doubt& doubt); // by a click or Enter, to be asked about

private:
  void addGroup(Doubt::Kind kind);
  void reportChosen(const QTreeWidgetItem* item);

  const PlantDocument& document_;
  Actions actions_;
  std::vector<Doubt> listed_; // by the number that its item keeps
  QLabel* title_;
  QLabel* agreement_;
  QLabel* note_;
  QLabel* question_;
  QWidget* asked_; // the question with its answers
  std::vector<QToolButton*> answers_;
  QToolButton* none_ = nullptr;
  QTreeWidget* list_;
};

} // namespace espalier
