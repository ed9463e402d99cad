#pragma once

#include "app/window/frame/window_part.h"
#include "ui/view/turntable.h"

#include <QTimer>

#include <memory>

class QWidget;

namespace espalier {

class ActionSet;
class JobSlot;
class PlantDocument;
class PlantView;
class TurntableFrames;

/// Writes the plant as it turns once, as a movie. Pictures are drawn one by one between what else
/// the window does, and written by a job.
class TurntableFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    JobSlot& jobs;
    ActionSet& actions;
    QWidget& window; // of dialogs
  };
  explicit TurntableFlow(const Parts& parts);
  ~TurntableFlow() override;

  void setEnabled(bool isEnabled) override;
  void setPlantShown(bool isShown) override;

private:
  void refresh();
  void choose();
  void write(const QString& path, int width, int seconds);
  void drawAsked();

  Parts parts_;
  bool isEnabled_ = true;
  bool isShown_ = false;
  int width_ = 800; // as chosen last
  int seconds_ = 6;
  std::unique_ptr<Turntable> turntable_; // while one is written
  std::shared_ptr<TurntableFrames> frames_;
  QTimer drawing_;
};

} // namespace espalier
