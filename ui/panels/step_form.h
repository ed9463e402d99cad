#pragma once

#include "core/pipeline/pipeline.h"

#include <QWidget>

#include <map>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace espalier {

class MethodForm;

/// One step of the pipeline: its name, how it went, its method and that method's options. Made from
/// the registry of methods.
class StepForm : public QWidget {
  Q_OBJECT

public:
  /// Stale: there is a result, but of other choices.
  enum class State { idle, stale, running, done, failed };

  /// @param number  0: none is shown
  StepForm(const Step& step, int number, QWidget* parent = nullptr);

  void setScale(const PlantScale& scale, const QString& unit);
  /// Shown behind the curve of a method whose radius follows the density: normalized to [0, 1].
  void setDensities(std::vector<float> densities);
  /// @param details what there is to say of it, as the time that it took; shown as a tip
  void setState(State state, const QString& note = {}, const QString& details = {});
  [[nodiscard]] State state() const { return current_; }
  void setRunnable(bool isRunnable);
  void setOpen(bool isOpen);
  [[nodiscard]] const Step& step() const { return step_; }

  /// Adds what the user has chosen here to `options`.
  void addTo(PipelineOptions& options) const;
  /// Shows what `options` say of this step; the rest is as the rules say. Notifies nobody. What was
  /// set of its other methods is forgotten.
  void choose(const PipelineOptions& options);

signals:
  void changed();
  void opened();
  void runRequested(); // up to here

private:
  using Settings = std::map<std::string, Rule>; // of options, by name

  void showMethod();
  void setFields(const Settings& settings);
  void takeMethod(); // another, with what was set of it before
  void showTip();
  void showCount(); // how much is set otherwise than by default
  [[nodiscard]] Settings chosenSettings() const;
  [[nodiscard]] const Method& chosenMethod() const;

  const Step& step_;
  PlantScale scale_{.spacing = 1, .height = 100};
  QString unit_;
  QToolButton* header_;
  QLabel* count_;
  QLabel* note_;
  QLabel* state_;
  State current_ = State::idle;
  QString stateTip_; // what there is to say of it
  QToolButton* run_;
  QWidget* body_;
  QVBoxLayout* column_;
  QComboBox* method_;
  MethodForm* form_ = nullptr;               // of the method chosen
  std::map<const Method*, Settings> before_; // of the other methods, as they were left
  std::vector<float> densities_;
};

} // namespace espalier
