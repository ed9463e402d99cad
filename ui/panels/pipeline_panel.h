#pragma once

#include "core/pipeline/pipeline.h"

#include <QWidget>

#include <functional>
#include <string>
#include <vector>

class QCheckBox;
class QPushButton;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace espalier {

class MeasuresForm;
class PlantDocument;
class StepForm;

/// The steps from scan to skeleton, each with its generated form, and the button that runs them.
class PipelinePanel : public QWidget {
  Q_OBJECT

public:
  explicit PipelinePanel(PlantDocument& document, QWidget* parent = nullptr);

  [[nodiscard]] PipelineOptions options() const;
  /// Shows these choices of steps; all else follows the rules. What no step has is passed over.
  /// Root and up stay: they are of the scan, as the points set aside.
  void setOptions(const PipelineOptions& options);
  [[nodiscard]] const std::vector<StepForm*>& steps() const { return steps_; }

  /// What is to be shown of a step that is up to date.
  struct StepText {
    QString note;    // short: the time that it took
    QString details; // a sentence
  };
  using StepTexts = std::function<StepText(const Step&)>;

  /// Marks the step of this label as running, and those before it as done.
  void showRunning(const QString& stage);
  /// Marks all steps up to the one of this name (empty: all) as up to date.
  void showDone(const StepTexts& texts = {}, const std::string& last = {});
  /// The same of those whose choices, and those before, are the ones that the plant was made with.
  void showMadeWith(const PipelineOptions& made, const StepTexts& texts, const std::string& last);
  /// Marks the step that is running as failed, and those behind it as not run.
  void showFailed(const QString& why);
  /// Forgets how steps went.
  void showIdle();
  /// A stopped run: the step that was running, and those behind it, are to be run again.
  void showStopped();
  void setRunnable(bool isRunnable);
  void addBelowScan(QWidget* widget); // above the steps; the panel owns it
  /// How dense the points lie, normalized to [0, 1]: shown where radii of this step follow it.
  void setDensities(const std::string& step, const std::vector<float>& densities);
  [[nodiscard]] MeasuresForm& measures() { return *measures_; } // of the scan
  /// Whether each change is to be shown at once.
  [[nodiscard]] bool isLive() const;
  void setLive(bool isLive);

signals:
  void changed(const espalier::Step& step); // an option of it, by hand
  void replaced();                          // all choices, by setOptions()
  void reconstructRequested();
  void rootAsked();                              // it is to be picked in the view
  void runRequested(const espalier::Step& last); // up to this one
  void liveToggled(bool isLive);

private:
  [[nodiscard]] QWidget* makeFold(QWidget* page);
  void showOptional();
  void scrollTo(const StepForm& form);
  void refreshScale();
  void showScale();
  [[nodiscard]] const StepForm* firstFromRoot() const;
  void takeRoot();
  void takeUp();
  void markStale(const StepForm* from);
  void markStaleSince(const PipelineOptions& before);

  PlantDocument& document_;
  QScrollArea* scroll_;
  QVBoxLayout* column_;
  MeasuresForm* measures_ = nullptr;
  std::vector<StepForm*> steps_;
  QToolButton* fold_ = nullptr; // shows the steps that are off by default
  QCheckBox* live_;
  QPushButton* run_;
};

} // namespace espalier
