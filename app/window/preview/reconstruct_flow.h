#pragma once

#include "app/window/preview/shared_pipeline.h"
#include "core/project/history.h"
#include "ui/panels/pipeline_panel.h"

#include <QString>

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace espalier {

class ActionSet;
class JobSlot;
class PlantDocument;

/// From scan to skeleton as a job, or a part of its steps; the result is one undo step.
class ReconstructFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobSlot& jobs;
    ActionSet& actions;
    PipelinePanel& panel;
  };
  explicit ReconstructFlow(const Parts& parts);

  void setEnabled(bool isEnabled) override;
  void setPlantShown(bool isShown) override;
  [[nodiscard]] const std::shared_ptr<SharedPipeline>& pipeline() const { return pipeline_; }
  [[nodiscard]] bool isUsedKnown() const { return used_ != nullptr; }
  /// What the skeleton was made with; as the rules say if that is not known.
  [[nodiscard]] PipelineOptions used() const {
    return used_ != nullptr ? used_->options : PipelineOptions();
  }
  /// The same, and which run it was, as a text; empty if it is not known.
  [[nodiscard]] std::string usedText() const;
  /// How long steps took, and what they said of their results, for the panel of the pipeline.
  [[nodiscard]] PipelinePanel::StepTexts stepTexts() const;
  void showUsed() const; // in the panel, at the steps that it is of; none if it is not known
  void showDone(const std::string& last) const; // likewise, of a run that ends now
  /// @throws Error if it is no such text
  void setUsed(const std::string& text);

signals:
  void starting();                                            // by hand
  void usedChanged();                                         // by undo and redo, and setUsed()
  void done(const QString& message, const std::string& last); // a step; empty: all

private:
  /// One that made a skeleton.
  struct Run {
    PipelineOptions options;
    std::string last;                          // its last step; empty: of all
    StepId made = {};                          // what it is in the history
    std::map<std::string, QString> notes = {}; // of its steps, by name
  };
  /// @param last  the step to end with; none: the last there is. Before the skeleton, the one there
  ///              is stays, and has other contracted points.
  /// @throws Error if there is no scan, or another job is running
  /// @param isConfirmed  that work by hand is replaced; else it is asked
  void start(const Step* last = nullptr, bool isConfirmed = false);
  /// Says what of the work by hand would be replaced, and offers to; false: nothing.
  [[nodiscard]] bool asksFirst(const Step* last);
  void show(const Reconstruction& result, const Step* last, const PipelineOptions& options,
            double seconds);
  void add(Run run);
  void forgetRuns();
  void refreshUsed();
  [[nodiscard]] QString nameOf(const PipelineOptions& options) const; // of a run, in the history

  PlantDocument& document_;
  JobSlot& jobs_;
  ActionSet& actions_;
  PipelinePanel& panel_;
  std::shared_ptr<SharedPipeline> pipeline_; // keeps the results of steps
  std::list<Run> runs_;                      // of the history, the last behind
  const Run* used_ = nullptr;                // the last that is not undone; null: there is none
  std::map<std::string, QString> notes_;     // of the steps that ran last, by name
  bool isRunning_ = false;
  bool isEnabled_ = true;
};

} // namespace espalier
