#include "core/pipeline/pipeline.h"

#include "core/base/shown_message.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/recent.h"

namespace espalier {
namespace {

/// What is asked of one step.
struct AskedStep {
  ChosenStep choice;
  std::optional<Eigen::Index> root = {};          // a point, if the method sees it
  std::optional<UpAxis> up = {};                  // likewise
  std::optional<Eigen::Vector3d> chosenRoot = {}; // of methods that clean, which see no other
  OrganMarks organs = {};                         // set by hand, if the method sees them
  bool operator==(const AskedStep&) const = default;
};

/// All that the result of a step follows from, but the cloud.
struct Chain {
  std::shared_ptr<const PointSet> leftOut;
  std::vector<AskedStep> choices; // of the steps up to it
  bool operator==(const Chain& other) const {
    return choices == other.choices && (leftOut == other.leftOut || *leftOut == *other.leftOut);
  }
};

/// All that the extent of the plant follows from, but the cloud.
struct ExtentKey {
  PointSet leftOut;
  UpAxis up;
  bool operator==(const ExtentKey&) const = default;
};

/// All that the root follows from, but the cloud.
struct RootKey {
  Chain cleaned;
  std::optional<Eigen::Vector3d> root;
  UpAxis up;
  bool operator==(const RootKey&) const = default;
};

/// All steps up to and including `last` (empty: all) that are on.
std::vector<const Step*> stepsUpTo(const std::string& last, const PipelineOptions& options) {
  std::vector<const Step*> steps;
  for (const Step& step : pipelineSteps()) {
    if (step.name == last || !isOff(step, options)) steps.push_back(&step);
    if (step.name == last) break;
  }
  return steps;
}

/// Before anything is run, of the steps whose scale is known.
/// @throws Error if a value is out of range
void requireInRange(const std::vector<const Step*>& steps, const PipelineOptions& options,
                    const PlantScale& scale) {
  for (const Step* step : steps)
    if (chosenFor(*step, options, scale).method->changesScale) return;
}

/// What is asked of a step, where the plant has its root at this point.
AskedStep askedOf(const Step& step, const PipelineOptions& options, const PlantScale& scale,
                  Eigen::Index root) {
  AskedStep asked{.choice = {&step, chosenFor(step, options, scale)}};
  const Method& method = *asked.choice.method.method;
  if (method.seesUp || method.changesScale) asked.up = options.up;
  if (method.seesOrgans) asked.organs = options.organs;
  if (!method.seesRoot) return asked;
  if (step.makes == StepResult::cleaned)
    asked.chosenRoot = options.root;
  else
    asked.root = root;
  return asked;
}

StepRecord recordOf(const ChosenStep& choice, bool isNew) {
  const Method& method = *choice.method.method;
  StepRecord record{.step = choice.step->name, .method = method.name, .values = {}, .isNew = isNew};
  for (std::size_t v = 0; v < choice.method.values.size(); ++v)
    record.values.emplace_back(method.options[v].name, choice.method.values[v]);
  return record;
}

} // namespace

/// What the last runs computed of one cloud.
struct Pipeline::Kept {
  std::shared_ptr<const PointCloud> cloud;
  Recent<ExtentKey, PlantExtent> extents;
  Recent<RootKey, Eigen::Index> roots;
  std::vector<Recent<Chain, PipelineState>> states; // by step

  void forget(const std::shared_ptr<const PointCloud>& newCloud) {
    *this = {};
    cloud = newCloud;
    states.resize(pipelineSteps().size());
  }

  /// Sets `index` to that of the cloud, if it takes one.
  [[nodiscard]] PlantExtent measured(const PipelineOptions& options, const Progress& progress,
                                     std::shared_ptr<const SpatialIndex>& index) {
    const ExtentKey key{options.leftOut, options.up};
    if (const PlantExtent* known = extents.find(key)) return *known;
    index = std::make_shared<const SpatialIndex>(cloud->positions(), progress);
    return extents.keep(key, plantExtent(*cloud, *index, options.leftOut, options.up));
  }

  /// The state after the last step of `chain`, computed from that before it.
  const PipelineState& computed(const Chain& chain, PipelineState state, const Progress& progress,
                                const StepWatch& watch) {
    chain.choices.back().choice.run(state, progress, watch);
    state.index.reset(); // not worth its memory from one run to the next
    return states[chain.choices.size() - 1].keep(chain, std::move(state));
  }

  [[nodiscard]] Eigen::Index rootOf(const Chain& cleaned, const PipelineState& state,
                                    const PipelineOptions& options, float lowest) {
    const RootKey key{cleaned, options.root, options.up};
    if (const Eigen::Index* known = roots.find(key)) return *known;
    return roots.keep(key, rootPoint(state, options, lowest));
  }

  /// @throws Error if nothing can be made of the cloud
  void take(const std::shared_ptr<const PointCloud>& newCloud, const PipelineOptions& options) {
    requireKnown(options);
    if (newCloud->size() < 2)
      throw ShownError({espalier::Shown::tr("a plant needs at least 2 points: check the scan")});
    requireNearRoot(*newCloud, options);
    if (cloud != newCloud) forget(newCloud);
  }

  /// @param index of the cloud, if there is one
  Reconstruction run(const PlantExtent& extent, const std::shared_ptr<const SpatialIndex>& index,
                     const PipelineOptions& options, const Progress& progress,
                     const std::string& last, const StepWatch& watch) {
    if (extent.scale.spacing == 0) {
      requirePlant(others(options.leftOut, cloud->size()));
      throw ShownError(
          {espalier::Shown::tr("all points of the scan are at the same place: check the scan")});
    }
    Reconstruction result;
    result.scale = extent.scale;
    const std::vector<const Step*> steps = stepsUpTo(last, options);
    requireInRange(steps, options, extent.scale);
    PlantExtent now = extent;
    StepShares shares(steps, progress);
    Chain chain{std::make_shared<const PointSet>(options.leftOut), {}};
    const PipelineState* state = nullptr;
    Eigen::Index root = 0;
    for (const Step* step : steps) {
      const Progress part = shares.next(*step);
      part.update(0); // the step whose values may be out of range
      chain.choices.push_back(askedOf(*step, options, now.scale, root));
      const ChosenStep& choice = chain.choices.back().choice;
      const PipelineState* known = states[chain.choices.size() - 1].find(chain);
      result.steps.push_back(recordOf(choice, known == nullptr));
      result.steps.back().scale = now.scale;
      if (known == nullptr) {
        PipelineState next = state == nullptr ? firstState(cloud, options) : *state;
        next.root = root;
        next.up = options.up;
        next.chosenRoot = options.root;
        next.organs = options.organs;
        next.extent = now;
        next.index = index;
        next.notes.clear();
        known = &computed(chain, std::move(next), part, watch);
      }
      state = known;
      result.steps.back().notes = state->notes;
      result.steps.back().leftOut = state->newlyLeftOut;
      if (choice.method.method->changesScale) now = state->extent;
      if (step->makes == StepResult::cleaned && (step == &cleaningStep() || step == steps.back()))
        root = rootOf(chain, *state, options, now.lowest);
    }
    result.scale = now.scale;
    result.apart = state->apart;
    result.contracted = state->contracted;
    result.skeleton = state->skeleton;
    result.ends = state->ends;
    result.gaps = state->gaps;
    progress.update(1);
    return result;
  }
};

std::vector<std::string> notesOf(const Reconstruction& reconstruction) {
  std::vector<std::string> notes;
  for (const StepRecord& record : reconstruction.steps)
    for (const std::string& note : eachInEnglish(record.notes))
      notes.push_back(stepNamed(record.step).label + ": " + note);
  return notes;
}

Pipeline::Pipeline() : kept_(std::make_unique<Kept>()) {}
Pipeline::~Pipeline() = default;
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&&) noexcept = default;

Reconstruction Pipeline::run(const std::shared_ptr<const PointCloud>& cloud,
                             const PipelineOptions& options, const Progress& progress,
                             const std::string& last, const StepWatch& watch) {
  kept_->take(cloud, options);
  std::shared_ptr<const SpatialIndex> index;
  const PlantExtent extent = kept_->measured(options, progress, index);
  return kept_->run(extent, index, options, progress, last, watch);
}

} // namespace espalier
