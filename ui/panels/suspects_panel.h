#pragma once

#include "core/doubt/doubt.h"
#include "ui/panels/suspects_model.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QToolButton;
class QTreeView;

namespace espalier {

class CheckForm;
class PlantDocument;

/// All that may be wrong with the plant, what matters most first; and the doubt that is asked
/// about, with its answers.
class SuspectsPanel : public QWidget {
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
    QAction* previous;
    QAction* next;
    QAction* ignore;
    std::vector<QAction*> places; // what of the plant is listed, each named by its text
  };
  /// @param checks  which it shows below the list
  SuspectsPanel(const PlantDocument& document, const Actions& actions, CheckForm& checks,
                SuspectsModel::TextOf textOf, QWidget* parent = nullptr);

  void show(std::vector<Suspect> suspects);
  [[nodiscard]] const std::vector<Suspect>& suspects() const { return model_->suspects(); }
  void setCurrent(std::optional<std::size_t> row); // reports no choice
  [[nodiscard]] std::optional<std::size_t> current() const;

  /// The kinds to choose from, each with its text and number; one is chosen.
  struct Kind {
    QString text;
    int kind = 0;
    bool operator==(const Kind&) const = default;
  };
  void showKinds(const std::vector<Kind>& kinds, int chosen);
  void showPlace(std::size_t place); // of those of the actions
  void showTitle(const QString& text);
  void showNote(const QString& text);     // why there are none, or that they are looked for
  void showSentence(const QString& text); // of the current one; empty: none
  /// @param text    how much is right; empty: it is not known
  /// @param isOfNow else it is of the plant before the last edits, and is grey
  void showAgreement(const QString& text, bool isOfNow);
  /// @param doubt    that is asked about; none: nothing is
  /// @param isByHand no alternative was right: it is corrected with a tool
  void showQuestion(const std::optional<Doubt>& doubt, bool isByHand);

signals:
  void chosen(std::size_t row); // by a click or Enter
  void currentChanged();
  void kindChosen(int kind);

private:
  [[nodiscard]] QWidget* makeQuestion();
  void makeFilters();
  void makeWalk();
  void makeList();
  void holdAnswers();
  void showFirst();
  void refreshShown();

  const PlantDocument& document_;
  Actions actions_;
  CheckForm& checks_;
  SuspectsModel* model_;
  QLabel* title_;
  QLabel* agreement_;
  QLabel* note_;
  QLabel* question_;
  QWidget* asked_; // the question with its answers
  std::vector<QToolButton*> answers_;
  QToolButton* none_ = nullptr;
  QComboBox* kinds_;
  QComboBox* places_;
  std::vector<Kind> shownKinds_;
  QTreeView* list_;
  QLabel* sentence_; // what the current one is, and what can be done
  QWidget* walk_;    // from one to another; absent where there is none
  QToolButton* ignore_ = nullptr;
  QToolButton* rest_ = nullptr;
};

} // namespace espalier
