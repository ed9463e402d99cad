#pragma once

#include "core/base/progress.h"
#include "core/base/shown_message.h"
#include "core/cloud/organ_marks.h"
#include "core/cloud/point_cloud.h"
#include "core/decide/decide_ends.h"
#include "core/decide/decide_gaps.h"
#include "core/graph/densities.h"
#include "core/graph/find_root.h"
#include "core/pipeline/method_probe.h"
#include "core/pipeline/option_table.h"
#include "core/pipeline/plant_scale.h"
#include "core/skeleton/skeleton.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// What steps hand on, in the order in which it comes to be. What was made before stays there.
enum class StepResult {
  scan,       // by no step: the points that were not set aside
  cleaned,    // which of them are of the plant; then it has a root
  smoothed,   // where the surface is that they sample; without this step, where they were scanned
  contracted, // where they are drawn to
  skeleton,   // all of it but the radii
  radii
};

/// What the steps of the pipeline hand on to each other.
struct PipelineState {
  std::shared_ptr<const PointCloud> cloud;
  std::vector<bool> isLeftOut; // by point: set aside, then cleaned
  /// Where the points are by now: scanned, smoothed, then contracted. By point, about the origin of
  /// the cloud.
  std::shared_ptr<const Eigen::Matrix3Xf> contracted;
  Eigen::Index root = 0;              // a point
  StepResult made = StepResult::scan; // the last that is there
  /// In the frame of the file; states share it.
  std::shared_ptr<const Skeleton> skeleton = std::make_shared<const Skeleton>();
  std::shared_ptr<const std::vector<EndDecision>> ends = {}; // as they were decided; null: not
  std::shared_ptr<const std::vector<GapDecision>> gaps = {}; // likewise
  /// Of all points of the cloud, if it is at hand: see scannedIndex.
  std::shared_ptr<const SpatialIndex> index = {};
  /// Of the whole scan, if this is a part of one: for contractions that follow densities.
  std::optional<DensityLevels> densityLevels = {};
  /// What the last step has to say of its result: sentences without a full stop.
  std::vector<ShownMessage> notes = {};
  Eigen::Index newlyLeftOut = 0; // points that the last step left out
  UpAxis up = UpAxis::z;
  std::optional<Eigen::Vector3d> chosenRoot = {}; // [L], frame of the file; by the user
  /// What the rules of the next steps follow from: of the whole scan, and of what is left from a
  /// method on that changes the scale.
  PlantExtent extent = {};
  std::shared_ptr<const PointSet> apart = {}; // left out by such methods; null: nothing
  OrganMarks organs = {};                     // that were set by hand, by point of the cloud
  /// Points of blades that were left out; null: none were looked for.
  std::shared_ptr<const std::vector<Eigen::Index>> blades = {};

  void setSkeleton(Skeleton found) {
    skeleton = std::make_shared<const Skeleton>(std::move(found));
  }
};

/// One way to do a step.
struct Method {
  std::string name;          // on the command line and in files
  std::string label;         // in menus and forms
  std::string help;          // one line
  std::string inManual = {}; // what the table of methods in the manual says of it
  std::string source;
  std::vector<Option> options;
  bool seesRoot = true;    // false: its result is the same wherever the plant has its root
  bool seesUp = false;     // true: not only by the height of the plant
  bool seesOrgans = false; // true: its result follows from organs that were set by hand
  /// True: what it leaves out is no stray of the plant, so that the rules of steps behind it follow
  /// from what is left.
  bool changesScale = false;
  /// True: reconstructs the plant to find out what to leave out. Only those who go on to a skeleton
  /// of the whole plant run it: see withoutTrials().
  bool triesPlant = false;
  bool cutsPlot = false; // true: it finds all plants, and keeps one (cleaned_scan.h)
  /// `values`: one per option, in order.
  std::function<void(PipelineState&, const std::vector<double>& values, const Progress&)> run;
  std::function<MethodProbe(const std::vector<double>& values)> probe =
      [](const std::vector<double>&) { return MethodProbe(); };
};

/// One step from scan to radii.
struct Step {
  std::string name;
  std::string label;
  std::string help;
  StepResult takes = StepResult::skeleton; // what must be there
  StepResult makes = StepResult::skeleton; // what it makes, or makes anew
  bool isOptional = false;                 // may be off: where it is, nobody runs or reports it
  double share = 1;                        // of the time of a run, for its progress
  std::vector<Method> methods;             // the first is the default
};

/// All steps in their order, each with all its methods.
[[nodiscard]] const std::vector<Step>& pipelineSteps();

[[nodiscard]] const Step& cleaningStep(); // the last of those that clean
[[nodiscard]] const Step& contractionStep();
[[nodiscard]] const Step& skeletonStep(); // makes it of points; others mend it

/// @throws Error that lists the names there are
[[nodiscard]] const Step& stepNamed(std::string_view name);
[[nodiscard]] const Method& methodNamed(const Step& step, std::string_view name);

} // namespace espalier
