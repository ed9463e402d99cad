#pragma once

#include "core/evaluate/evaluation.h"
#include "core/project/corrections.h"

#include <QScrollArea>
#include <QString>

class QGridLayout;
class QLabel;

namespace espalier {

class PlantDocument;

/// The scores of a comparison, and the work by hand, in two columns.
class EvaluationScores : public QScrollArea {
  Q_OBJECT

public:
  explicit EvaluationScores(const PlantDocument& document); // which outlives it

  void show(const Evaluation& evaluation);
  void forget();
  void setStale(bool isStale); // the plant has changed since
  void showHandWork(const HandWork& work);

private:
  QLabel* addScore(QGridLayout& grid, int row, int column, const QString& text, const QString& help,
                   const char* name);
  void fit(); // none is cut off

  const PlantDocument& document_;
  QWidget* scores_;
  QLabel* precision_;
  QLabel* recall_;
  QLabel* f_;
  QLabel* mapping_;
  QLabel* geometric_;
  QLabel* cappedGeometric_;
  QLabel* structural_;
  QLabel* structuralOfAll_;
  QLabel* tips_;
  QLabel* branchings_;
  QLabel* distances_;
  QLabel* edits_;
  QLabel* types_;
  QLabel* work_;
};

} // namespace espalier
