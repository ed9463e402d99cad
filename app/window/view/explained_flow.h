#pragma once

#include "app/window/frame/scan_distances.h"
#include "app/window/frame/window_part.h"

#include <QTimer>

#include <functional>

class QMainWindow;
class QSettings;

namespace espalier {

class ActionSet;
class ExplainedBar;
class PlantDocument;
class PointStates;

/// Dims or hides the points that the skeleton explains, so that what is missing stands out. Follows
/// every edit.
class ExplainedFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PointStates& states;
    ActionSet& actions;
    ScanDistances& distances;
    QSettings& settings;
    QMainWindow& window;                 // its central layout gets the bar
    std::function<double()> usualReach;  // of the checks [L]
    std::function<double()> sensitivity; // likewise
    std::function<void(double)> setSensitivity;
  };
  explicit ExplainedFlow(const Parts& parts);

  void setPlantShown(bool isShown) override;
  void takeLimits(); // of the checks: they are others

private:
  void makeBar();
  void turn(bool isOn);
  void showStates();

  Parts parts_;
  ExplainedBar* bar_ = nullptr;
  QTimer timer_;
  bool isPlantShown_ = false;
};

} // namespace espalier
