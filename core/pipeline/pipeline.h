#pragma once

#include "core/cloud/point_set.h"
#include "core/pipeline/registry.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// What the user decided; all else follows the rules of the option tables.
struct PipelineOptions {
  std::map<std::string, std::string> methods;                  // step -> method
  std::map<std::string, std::map<std::string, Rule>> settings; // step -> option -> value
  std::optional<Eigen::Vector3d> root;                         // [L], frame of the file
  UpAxis up = UpAxis::z;
  /// Points that were set aside: no step sees them, but rules follow from the whole scan. Of one
  /// scan, so no preset has them.
  PointSet leftOut = {};

  /// Sets one option by its full name, "step.option".
  /// Lengths are in [L], or follow from the scan: "7.5 spacings", "0.01 heights".
  /// @throws Error naming what there is, if the step is unknown or the value is no number, or none
  /// of the words that the option takes
  void set(const std::string& assignment); // "contract.radius=12.5"
  /// The same, in parts; `text` is a number, a length by a rule, or a word.
  void setText(const Step& step, const std::string& option, const std::string& text);

  bool operator==(const PipelineOptions&) const = default;
};

/// Checks the names of all steps, methods and options, before any scan is there.
/// @throws Error naming what there is
void requireKnown(const PipelineOptions& options);

/// What one step did, for the report.
struct StepRecord {
  std::string step;
  std::string method;
  std::vector<std::pair<std::string, double>> values; // option -> value used
  bool isNew = true;                                  // false: the result was at hand
};

struct Reconstruction {
  std::shared_ptr<const Eigen::Matrix3Xf> contracted; // by point, about the origin of the cloud
  Skeleton skeleton;                                  // frame of the file
  std::vector<RadiusSource> radiusSources;            // by id; empty without the last step
  PlantScale scale;
  std::vector<StepRecord> steps;
};

/// The values a step would use for a plant of this scale, one per option of its method, in order.
/// @throws Error if a setting is out of range
[[nodiscard]] std::vector<double> resolvedValues(const Step& step, const Method& method,
                                                 const PipelineOptions& options,
                                                 const PlantScale& scale);

/// From scan to skeleton with radii, step by step.
///
/// Keeps each step's result: a changed option recomputes only that step and those behind it.
class Pipeline {
public:
  Pipeline();
  ~Pipeline();
  Pipeline(Pipeline&&) noexcept;
  Pipeline& operator=(Pipeline&&) noexcept;

  /// Runs what has changed since the last run, up to and including step `last` (empty: all).
  ///
  /// @throws Error     if the cloud has fewer than 2 places, or an option is unknown or out of
  /// range
  /// @throws Cancelled if `progress` asks to stop; steps done until then are kept
  [[nodiscard]] Reconstruction run(const std::shared_ptr<const PointCloud>& cloud,
                                   const PipelineOptions& options = {},
                                   const Progress& progress = {}, const std::string& last = {});

private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

} // namespace espalier
