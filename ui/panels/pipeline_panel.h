#pragma once

#include "core/pipeline/pipeline.h"

#include <QWidget>

#include <vector>

class QPushButton;

namespace espalier {

class PlantDocument;
class StepForm;

/// The steps from scan to skeleton, each with its generated form, and the button that runs them.
class PipelinePanel : public QWidget {
  Q_OBJECT

public:
  explicit PipelinePanel(PlantDocument& document, QWidget* parent = nullptr);

  [[nodiscard]] PipelineOptions options() const;
  /// Shows these choices; all else follows the rules. What no step has is passed over.
  void setOptions(const PipelineOptions& options);
  [[nodiscard]] const std::vector<StepForm*>& steps() const { return steps_; }

  /// Marks the step of this label as running, and those before it as done.
  void showRunning(const QString& stage);
  void showDone();
  void showIdle();
  void setRunnable(bool isRunnable);

signals:
  void changed(); // an option, by hand
  void reconstructRequested();

private:
  void refreshScale();

  PlantDocument& document_;
  std::vector<StepForm*> steps_;
  QPushButton* run_;
};

} // namespace espalier
