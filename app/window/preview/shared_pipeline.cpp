#include "app/window/preview/shared_pipeline.h"

#include "ui/jobs/memory_use.h"

#include <QElapsedTimer>

#include <chrono>

namespace espalier {

std::unique_lock<std::timed_mutex> SharedPipeline::atWork(const Progress& progress) {
  std::unique_lock lock(working_, std::defer_lock);
  while (!lock.try_lock_for(std::chrono::milliseconds(20)))
    progress.check();
  return lock;
}

Reconstruction SharedPipeline::run(const std::shared_ptr<const PointCloud>& cloud,
                                   const PipelineOptions& options, const Progress& progress,
                                   const std::string& last) {
  const std::unique_lock lock = atWork(progress);
  QElapsedTimer elapsed;
  std::size_t before = 0;
  const StepWatch watch{.began =
                            [&](const Step&) {
                              before = memoryNow();
                              forgetMemoryPeak();
                              elapsed.start();
                            },
                        .ended =
                            [&](const Step& step) {
                              const std::size_t peak = memoryPeak();
                              const std::scoped_lock note(noting_);
                              costs_[step.name] = {static_cast<double>(elapsed.nsecsElapsed()) /
                                                       1e9,
                                                   peak > before ? peak - before : 0};
                            }};
  return pipeline_.run(cloud, options, progress, last, watch);
}

std::map<std::string, StepCost> SharedPipeline::costs() const {
  const std::scoped_lock lock(noting_);
  return costs_;
}

} // namespace espalier
