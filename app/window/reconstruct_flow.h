#pragma once

#include "app/window/shared_pipeline.h"
#include "ui/panels/pipeline_panel.h"

#include <QObject>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace espalier {

class JobRunner;
class PlantDocument;

/// From scan to skeleton as a job, or a part of the way; the result is one undo step.
class ReconstructFlow : public QObject {
  Q_OBJECT

public:
  ReconstructFlow(PlantDocument& document, JobRunner& jobs, QObject* parent);

  /// @param last  the step to end with; none: the last there is. Before the skeleton, the one there
  ///              is stays, and has other contracted points.
  /// @throws Error if there is no scan, or another job is running
  void start(const PipelineOptions& options, const Step* last = nullptr);
  [[nodiscard]] const std::shared_ptr<SharedPipeline>& pipeline() const { return pipeline_; }
  /// How long steps took, for the panel of the pipeline.
  [[nodiscard]] PipelinePanel::Telling telling() const;
  /// The options that led to the skeleton, if they are known.
  [[nodiscard]] const std::optional<PipelineOptions>& used() const { return used_; }
  /// Those of a plant that was made before.
  void setUsed(std::optional<PipelineOptions> used) { used_ = std::move(used); }
  [[nodiscard]] bool isRunning() const { return isRunning_; }

signals:
  void done(const QString& message, const std::string& last); // a step; empty: all

private:
  void show(const Reconstruction& result, const Step* last, double seconds);

  PlantDocument& document_;
  JobRunner& jobs_;
  std::shared_ptr<SharedPipeline> pipeline_; // keeps the results of steps
  std::optional<PipelineOptions> used_;
  bool isRunning_ = false;
};

} // namespace espalier
