#pragma once

#include "core/skeleton/axes.h"

#include <QScrollArea>
#include <QString>
#include <QTimer>

#include <array>

class QAction;
class QLabel;
class QLineEdit;
class QTableView;
class QVBoxLayout;

namespace espalier {

class AxisReviewModel;
class CoverageBar;
class PlantDocument;

/// How far the review is, what is said of the chosen nodes, and the list of axes. What is typed is
/// reported as a signal: the window makes the edit.
class ReviewPanel : public QScrollArea {
  Q_OBJECT

public:
  /// What its buttons do; the actions outlive it.
  struct Actions {
    QAction* previous;
    QAction* next;
    QAction* openEnd;
    QAction* branching;
    QAction* riskiestFirst;
    QAction* reviewed;
    QAction* doubtful;
    QAction* toDo;
    QAction* sign;
  };
  ReviewPanel(PlantDocument& document, const Actions& actions, QWidget* parent = nullptr);

  /// @param text  as "12 stops left"
  /// @param why   one should look closely there; empty: nothing is known of it
  void showPlace(const QString& text, const QString& why = {});
  void showSeal(const QString& text);
  void setReviewer(const QString& name);
  void focusComment();

signals:
  void axisChosen(const espalier::Axis& axis);
  void commentTyped(const QString& comment);
  void reviewerTyped(const QString& name);
  void leaveRequested(); // what was typed is taken: the keys are the plant's again

protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void addCoverage(QVBoxLayout& column);
  void addChosen(QVBoxLayout& column, const Actions& actions);
  void addAxes(QVBoxLayout& column);
  void addSeal(QVBoxLayout& column, const Actions& actions);
  void fitTexts();
  void later(); // many edits, as of a drag, are shown at once
  void refresh();
  void showSamples();
  void refreshChosen();

  PlantDocument& document_;
  AxisReviewModel* model_;
  CoverageBar* bar_;
  QLabel* share_;
  std::array<QLabel*, 3> samples_{}; // by ReviewState
  std::array<QLabel*, 3> lengths_{}; // likewise
  QLabel* place_;
  QLabel* why_;
  QLabel* state_;
  QLineEdit* comment_;
  QTableView* axes_;
  QLineEdit* reviewer_;
  QLabel* seal_;
  QTimer timer_;
};

} // namespace espalier
