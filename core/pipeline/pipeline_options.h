#pragma once

#include "core/cloud/organ_marks.h"
#include "core/cloud/point_set.h"
#include "core/pipeline/registry.h"

#include <map>
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
  /// Organs of points that were set by hand, which methods that look for organs take. Likewise.
  OrganMarks organs = {};

  /// Sets one option by its full name, "step.option". Another method of a step, "step.method",
  /// begins with its own defaults: what was set of the step before is gone.
  /// Lengths are in [L], or follow from the scan: "7.5 spacings", "0.01 heights"; or in mm, cm or
  /// m.
  /// @param meters  in the unit of the scan; 0: not known, and lengths in mm, cm and m are refused
  /// @throws Error naming what there is, if the step is unknown or the value is no number, or none
  /// of the words that the option takes, or has a unit that is none for it
  void set(const std::string& assignment, double meters = 0); // "contract.radius=12.5"
  /// The same of an option, in parts; `text` is a number, a length by a rule, or a word.
  void setText(const Step& step, const std::string& option, const std::string& text,
               double meters = 0);

  /// The same of a method. @throws Error naming what there is
  void choose(const Step& step, const std::string& method);

  bool operator==(const PipelineOptions&) const = default;
};

/// Checks the names of all steps, methods and options, before any scan is there.
/// @throws Error naming what there is
void requireKnown(const PipelineOptions& options);

/// The method of a step that was chosen, or else its first.
/// @throws Error naming what there is
[[nodiscard]] const Method& chosenMethod(const Step& step, const PipelineOptions& options);

/// The option of that name of a method of a step.
/// @throws ShownError naming what there is
[[nodiscard]] const Option& optionIn(const Step& step, const Method& method,
                                     const std::string& name);

/// Whether a step is optional, and does nothing.
[[nodiscard]] bool isOff(const Step& step, const PipelineOptions& options);

/// The same with the methods off that reconstruct the plant to find out what to leave out: for
/// those who clean a scan, or look at parts of it.
[[nodiscard]] PipelineOptions withoutTrials(const PipelineOptions& options);

/// The method of a step with its values.
struct ChosenMethod {
  const Method* method = nullptr;
  std::vector<double> values; // one per option, in order

  void run(PipelineState& state, const Progress& progress) const {
    method->run(state, values, progress);
  }
  [[nodiscard]] MethodProbe probe() const { return method->probe(values); }
  bool operator==(const ChosenMethod&) const = default;
};

/// What a step does with a plant of this scale.
/// @throws Error if the method is unknown or a setting is out of range
[[nodiscard]] ChosenMethod chosenFor(const Step& step, const PipelineOptions& options,
                                     const PlantScale& scale);

/// Whether both choose the same method of a step, and the same values for it.
[[nodiscard]] bool isSameIn(const Step& step, const PipelineOptions& a, const PipelineOptions& b);

/// What options hold for a step and a plant of this scale, one value per option of its method, in
/// order: as they are set, else by the rules. Those that were kept of another scale may be out of
/// range in this one.
[[nodiscard]] std::vector<double> valuesAsSet(const Step& step, const Method& method,
                                              const PipelineOptions& options,
                                              const PlantScale& scale);

/// The same, as a step would use them.
/// @throws Error if a setting is out of range
[[nodiscard]] std::vector<double> resolvedValues(const Step& step, const Method& method,
                                                 const PipelineOptions& options,
                                                 const PlantScale& scale);

} // namespace espalier
