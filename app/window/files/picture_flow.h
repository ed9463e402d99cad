#pragma once

#include "app/window/frame/window_part.h"

class QWidget;

namespace espalier {

class ActionSet;
class PlantDocument;
class PlantView;

/// Writes what the view shows as a picture.
class PictureFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    ActionSet& actions;
    QWidget& window; // of dialogs
  };
  explicit PictureFlow(const Parts& parts);

  void setPlantShown(bool isShown) override;

private:
  void choose();
  void write(const QString& path);

  Parts parts_;
};

} // namespace espalier
