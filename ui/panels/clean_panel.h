#pragma once

#include "core/pipeline/cleaning.h"

#include <QString>
#include <QWidget>

#include <map>
#include <optional>
#include <utility>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace espalier {

class MethodForm;

/// Finds points that are not of the plant by one of the methods of cleaning, and offers to set them
/// aside. What it finds is the selection of points, which the brush may mend before. The options of
/// each method stay as they were set until the choice is forgotten.
class CleanPanel : public QWidget {
  Q_OBJECT

public:
  /// What its buttons do beside that.
  struct Actions {
    std::vector<std::pair<QAction*, QString>> byHand;  // select what is painted, by name
    std::vector<std::pair<QAction*, QString>> byClick; // find what is clicked, by name
    QAction* keepOnly;
    QAction* invert;
    QAction* bringBack;
    QAction* showAside;
  };
  explicit CleanPanel(const Actions& actions, QWidget* parent = nullptr);

  void setScale(const PlantScale& scale, const QString& unit);

  /// What is to be found; none: nothing was chosen yet.
  struct Choice {
    CleaningMethod cleaning;
    std::vector<double> values; // one per option of the method
  };
  [[nodiscard]] std::optional<Choice> choice() const;
  void forgetChoice();

  void showFinding(double fraction); // it is looked for
  /// What is selected now, or why there is nothing.
  void showSelected(const QString& text, bool mayBeSetAside);
  void showAside(const QString& text); // what is set aside by now

signals:
  void changed(); // what is to be found, or it is to be found again
  void setAsideRequested();
  void cancelRequested(); // of what is looked for

private:
  void addChoice(QVBoxLayout& column);
  void addResult(QVBoxLayout& column, const Actions& actions);
  void showMethod();
  void keepOptions(); // of the form that is shown

  std::vector<CleaningMethod> methods_;
  PlantScale scale_{.spacing = 1, .height = 100};
  QString unit_;
  QComboBox* chosen_;
  QWidget* body_;
  MethodForm* form_ = nullptr; // of the method chosen, if one is
  std::map<const Method*, std::vector<std::optional<Rule>>> options_; // that were chosen before
  QPushButton* again_;
  QLabel* result_;
  QPushButton* cancel_;
  QPushButton* setAside_;
  QLabel* aside_;
};

} // namespace espalier
