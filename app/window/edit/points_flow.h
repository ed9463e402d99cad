#pragma once

#include "app/window/frame/window_part.h"
#include "ui/tools/point_question.h"
#include "ui/tools/select_points_tool.h"

#include <utility>
#include <vector>

class QAction;
class QMenu;

namespace espalier {

class ActionSet;
class Editing;
class PlantDocument;
class PointSet;
class PointStates;

/// What is done with points of the scan: they are selected, set aside and brought back, and shown
/// alone. To set them aside is a step of the history; what is shown is none.
class PointsFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    ActionSet& actions;
    Editing& editing;
    PointStates& states;
  };
  explicit PointsFlow(const Parts& parts);

  [[nodiscard]] SelectPointsTool& tool() const { return *tool_; }
  /// Sets the selected points aside, as one step. @param what they are; empty: not known
  /// @throws Error if none is selected, or nothing may be edited
  void setAside(const QString& what);

signals:
  void changed(); // what is shown alone

private:
  void fillContextMenu(QMenu& menu) const; // with what may be done to selected points, if any
  void addActions();
  void addChoices();
  void addShapes();
  void addThings();
  void addEdits();
  void addShown();
  void keepOnly();
  void bringBack();
  [[nodiscard]] bool bringsSomeBack() const; // those that are selected, not all
  void isolate();
  void nextShape();
  void changeBrush(double factor);
  void refreshEnabled();
  [[nodiscard]] const PointSet& chosen() const;

  Parts parts_;
  SelectPointsTool* tool_;
  std::vector<std::pair<QAction*, SelectPointsTool::Shape>> shapes_; // to be drawn
  std::vector<std::pair<QAction*, PointQuestion::Thing>> things_;    // to be clicked
};

} // namespace espalier
