#pragma once

#include "core/pipeline/pipeline.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace espalier {

class OptionField;

/// One step of the pipeline: its name, how it went, its method and that method's options. Made from
/// the registry of methods.
class StepForm : public QWidget {
  Q_OBJECT

public:
  enum class State { idle, running, done };

  StepForm(const Step& step, int number, QWidget* parent = nullptr);

  void setScale(const PlantScale& scale, const QString& unit);
  void setState(State state);
  void setOpen(bool isOpen);
  [[nodiscard]] const Step& step() const { return step_; }

  /// Adds what the user has chosen here to `options`.
  void addTo(PipelineOptions& options) const;
  /// Shows what `options` say of this step; the rest is as the rules say. Tells nobody.
  void choose(const PipelineOptions& options);

signals:
  void changed();

private:
  void showMethod();

  const Step& step_;
  PlantScale scale_{.spacing = 1, .height = 100};
  QString unit_;
  QToolButton* header_;
  QLabel* state_;
  QWidget* body_;
  QVBoxLayout* column_;
  QComboBox* method_;
  QWidget* options_ = nullptr; // of the method chosen
  std::vector<OptionField*> fields_;
};

} // namespace espalier
