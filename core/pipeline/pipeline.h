#pragma once

#include "core/pipeline/step_graph.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace espalier {

/// What one step did, for the report.
struct StepRecord {
  std::string step;
  std::string method;
  std::vector<std::pair<std::string, double>> values; // option -> value used
  bool isNew = true;                                  // false: the result was at hand
  std::vector<ShownMessage> notes = {};               // what is to be said of its result
  PlantScale scale = {};                              // that its rules follow from
  Eigen::Index leftOut = 0;                           // points it left out, of those that count
};

struct Reconstruction {
  std::shared_ptr<const Eigen::Matrix3Xf> contracted; // by point, about the origin of the cloud
  /// In the frame of the file; the pipeline keeps it, too.
  std::shared_ptr<const Skeleton> skeleton = std::make_shared<const Skeleton>();
  /// What was asked of the ends of the skeleton (core/decide/decide_ends.h). Null: nothing.
  std::shared_ptr<const std::vector<EndDecision>> ends;
  /// What was asked of the gaps in it (core/decide/decide_gaps.h). Null: nothing.
  std::shared_ptr<const std::vector<GapDecision>> gaps;
  PlantScale scale; // of what is left, if cleaning changed it
  /// Points that cleaning took for no part of the plant, where more than strays: they stay where
  /// they are. Null: none.
  std::shared_ptr<const PointSet> apart;
  std::vector<StepRecord> steps; // those that are on
};

/// The notes of all steps of a run in English, each behind the label of its step.
[[nodiscard]] std::vector<std::string> notesOf(const Reconstruction& reconstruction);

/// From scan to skeleton with radii, step by step.
///
/// A changed option recomputes only that step and those behind it; a changed root, or up axis, only
/// what sees it. Of each step the results of the last 4 different choices are kept, where a choice
/// is that of all steps up to it and of the points set aside: going back to one computes nothing.
/// For each of the 4 that is 12 bytes a point (the contracted places), a few bits a point and step,
/// and the skeleton after each step. Another cloud drops them all.
class Pipeline {
public:
  Pipeline();
  ~Pipeline();
  Pipeline(Pipeline&&) noexcept;
  Pipeline& operator=(Pipeline&&) noexcept;

  /// Runs what is not at hand, up to and including step `last` (empty: all).
  ///
  /// @throws Error     if the cloud has fewer than 2 places, or an option is unknown or out of
  /// range
  /// @throws Cancelled if `progress` asks to stop; steps done until then are kept
  [[nodiscard]] Reconstruction run(const std::shared_ptr<const PointCloud>& cloud,
                                   const PipelineOptions& options = {},
                                   const Progress& progress = {}, const std::string& last = {},
                                   const StepWatch& watch = {});

private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

} // namespace espalier
