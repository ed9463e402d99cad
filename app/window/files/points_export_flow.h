#pragma once

#include "app/window/frame/window_part.h"

class QWidget;

namespace espalier {

class ActionSet;
class JobSlot;
class PlantDocument;

/// Writes the points of the scan that are not set aside into a file of their own.
class PointsExportFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobSlot& jobs;
    ActionSet& actions;
    QWidget& window; // of dialogs
  };
  explicit PointsExportFlow(const Parts& parts);

  void setEnabled(bool isEnabled) override;

private:
  void refresh();
  void choose();
  void write(const QString& path);

  Parts parts_;
  bool isEnabled_ = true;
};

} // namespace espalier
