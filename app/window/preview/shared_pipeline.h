#pragma once

#include "core/pipeline/pipeline.h"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace espalier {

/// What computing a step took, the last time that it was.
struct StepCost {
  double seconds = 0;
  std::size_t bytes = 0; // the program grew by, at most
};

/// The pipeline of a plant, for jobs on any thread: one works with it at a time, others wait for
/// that one, unless they are asked to stop. So what a preview computed is at hand when the plant is
/// reconstructed.
class SharedPipeline {
public:
  /// As Pipeline::run().
  [[nodiscard]] Reconstruction run(const std::shared_ptr<const PointCloud>& cloud,
                                   const PipelineOptions& options, const Progress& progress,
                                   const std::string& last = {});

  /// By the name of the step. May be asked for while it runs.
  [[nodiscard]] std::map<std::string, StepCost> costs() const;

private:
  /// The right to work; @throws Cancelled if `progress` asks to stop before
  std::unique_lock<std::timed_mutex> atWork(const Progress& progress);

  std::timed_mutex working_;
  Pipeline pipeline_;
  mutable std::mutex noting_;
  std::map<std::string, StepCost> costs_;
};

} // namespace espalier
