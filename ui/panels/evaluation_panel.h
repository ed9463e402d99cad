#pragma once

#include "core/evaluate/evaluation.h"
#include "core/evaluate/study/ranking.h"
#include "core/project/corrections.h"

#include <QString>
#include <QStringList>
#include <QWidget>

#include <map>
#include <string>

class QAction;
class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;

namespace espalier {

class EvaluationScores;
class PlantDocument;

/// How well the plant agrees with its reference: what is compared, at which tolerance, the scores,
/// and beside them the curve and the list of errors, which are widgets of their own.
class EvaluationPanel : public QWidget {
  Q_OBJECT

public:
  /// What stands in it, and what its buttons do; it owns the widgets.
  struct Parts {
    QWidget* plot;
    QWidget* errors;
    QWidget* alone;  // shown while there is no reference
    QAction* color;  // colors both skeletons by what differs
    QAction* report; // writes all of it to a file
    QMenu* edits;    // what the edit distance counts; not owned
  };
  EvaluationPanel(const PlantDocument& document, const Parts& parts, QWidget* parent = nullptr);

  /// Empty: there is none, and what is known of the plant alone is shown instead of scores.
  void setReference(const QString& name);
  void showScores(const Evaluation& evaluation);
  void showIntervals(const std::map<std::string, ScoreInterval>& intervals); // of those, by key
  void forgetScores();
  void setStale(bool isStale); // the plant has changed since
  void showHandWork(const HandWork& work);
  void showProgress(double fraction); // of comparing; in [0, 1]
  /// Comparing has ended; if `text` is not empty it did not go well, or was stopped.
  void showRest(const QString& text);

  void setTolerance(double tolerance); // [L]
  void setLaid(bool isLaid);
  void setTurns(bool turns);
  void setMovable(bool isMovable); // false: the reference lies where it is

signals:
  void toleranceChosen(double tolerance);
  void laidChosen(bool isLaid); // whether the reference is laid on the plant
  void turnsChosen(bool turns); // and turned for it
  void cancelRequested();
  void compareRequested();

private:
  QWidget* makeHead(const Parts& parts);
  void refreshPlace(const Evaluation& evaluation);
  [[nodiscard]] QString placeTip(const Registration& lay) const;
  [[nodiscard]] QString length(double value) const;

  const PlantDocument& document_;
  QWidget* content_;
  QWidget* empty_;
  EvaluationScores* scores_;
  QLabel* title_;
  QLabel* shift_;
  QLabel* warnings_;
  QLabel* state_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QPushButton* compare_;
  QCheckBox* laid_;
  QCheckBox* turns_;
  QDoubleSpinBox* tolerance_;
};

} // namespace espalier
