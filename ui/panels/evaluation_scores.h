#pragma once

#include "core/evaluate/evaluation.h"
#include "core/evaluate/study/ranking.h"
#include "core/project/corrections.h"

#include <QScrollArea>
#include <QString>

#include <map>
#include <string>

class QGridLayout;
class QLabel;

namespace espalier {

class PlantDocument;

/// The scores of a comparison: the leading ones in large at the top, then all in their groups, and
/// the work by hand, in two columns.
class EvaluationScores : public QScrollArea {
  Q_OBJECT

public:
  explicit EvaluationScores(const PlantDocument& document); // which outlives it

  void show(const Evaluation& evaluation);
  /// By key: how much of each score is owed to the segments that this plant happens to have.
  void showIntervals(const std::map<std::string, ScoreInterval>& intervals);
  void forget();
  void setStale(bool isStale); // the plant has changed since
  void showHandWork(const HandWork& work);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  struct Place; // where the next row goes
  void addLeading(QGridLayout& grid);
  void addScores(QGridLayout& grid);
  void addGroup(QGridLayout& grid, Place& place, const QString& name);
  QLabel* addValue(QGridLayout& grid, Place& place, const QString& text, const QString& help,
                   const char* name);
  void fit(); // none is cut off
  void endBetweenRows();

  const PlantDocument& document_;
  QWidget* scores_;
  std::map<std::string, QLabel*> leading_; // by key of the score
  std::map<std::string, QLabel*> values_;  // likewise
  QLabel* stems_;                          // why their diameters are not shown
  QLabel* work_;
};

} // namespace espalier
