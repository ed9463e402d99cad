#pragma once

#include "core/pipeline/pipeline.h"

#include <QObject>

#include <memory>

namespace espalier {

class JobRunner;
class PlantDocument;

/// From scan to skeleton as a job; the result is one undo step.
class ReconstructFlow : public QObject {
  Q_OBJECT

public:
  ReconstructFlow(PlantDocument& document, JobRunner& jobs, QObject* parent);

  /// @throws Error if there is no scan, or another job is running
  void start(const PipelineOptions& options);
  [[nodiscard]] bool isRunning() const { return isRunning_; }

signals:
  void done(const QString& message);

private:
  void show(const Reconstruction& result, double seconds);

  PlantDocument& document_;
  JobRunner& jobs_;
  std::shared_ptr<Pipeline> pipeline_; // keeps the results of steps; used by one job at a time
  bool isRunning_ = false;
};

} // namespace espalier
