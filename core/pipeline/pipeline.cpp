#include "core/pipeline/pipeline.h"

#include "core/base/error.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/recent.h"
#include "core/skeleton/finite_node.h"

namespace espalier {
namespace {

/// What is asked of one step.
struct ChosenStep {
  const Step* step;
  const Method* method;
  std::vector<double> values;
  std::optional<Eigen::Index> root = {}; // a point, if the method sees it
  bool operator==(const ChosenStep&) const = default;
};

/// All that the result of a step follows from, but the cloud.
struct Chain {
  std::shared_ptr<const PointSet> leftOut;
  std::vector<ChosenStep> choices; // of the steps up to it
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

/// The choices of all steps up to `last`.
/// @throws Error if a value is out of range
std::vector<ChosenStep> choicesUpTo(const std::string& last, const PipelineOptions& options,
                                    const PlantScale& scale) {
  std::vector<ChosenStep> choices;
  for (const Step& step : pipelineSteps()) {
    const Method& method = chosenMethod(step, options);
    choices.push_back({&step, &method, resolvedValues(step, method, options, scale)});
    if (step.name == last) break;
  }
  return choices;
}

StepRecord recordOf(const ChosenStep& choice, bool isNew) {
  StepRecord record{
      .step = choice.step->name, .method = choice.method->name, .values = {}, .isNew = isNew};
  for (std::size_t v = 0; v < choice.values.size(); ++v)
    record.values.emplace_back(choice.method->options[v].name, choice.values[v]);
  return record;
}

/// @throws Error if a step made what no file and no project can keep
void requireFinite(const Skeleton& skeleton, const ChosenStep& choice) {
  for (const NodeId id : skeleton.ids())
    if (!isFinite(skeleton[id]))
      throw Error("step " + choice.step->name + ", method " + choice.method->name + ": node " +
                  std::to_string(indexOf(id)) +
                  " gets a position or radius that is not finite: choose another method, and check "
                  "the scan for many points at one place");
}

/// The progress of each step, as a part of that of a run of all.
class Shares {
public:
  explicit Shares(const Progress& whole) : whole_(whole) {
    for (const Step& step : pipelineSteps())
      total_ += step.share;
  }
  Progress next(const Step& step) {
    const double from = done_;
    done_ += step.share / total_;
    return whole_.part(from, done_, step.label);
  }

private:
  const Progress& whole_;
  double total_ = 0;
  double done_ = 0;
};

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
    const ChosenStep& choice = chain.choices.back();
    if (watch.began) watch.began(*choice.step);
    choice.method->run(state, choice.values, progress);
    requireFinite(*state.skeleton, choice);
    state.index.reset(); // not worth its memory from one run to the next
    if (watch.ended) watch.ended(*choice.step);
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
    if (newCloud->size() < 2) throw Error("a plant needs at least 2 points: check the scan");
    requireNearRoot(*newCloud, options);
    if (cloud != newCloud) forget(newCloud);
  }

  /// @param index of the cloud, if there is one
  Reconstruction run(const PlantExtent& extent, const std::shared_ptr<const SpatialIndex>& index,
                     const PipelineOptions& options, const Progress& progress,
                     const std::string& last, const StepWatch& watch) {
    if (extent.scale.spacing == 0) {
      requirePlant(others(options.leftOut, cloud->size()));
      throw Error("all points of the scan are at the same place: check the scan");
    }
    Reconstruction result;
    result.scale = extent.scale;
    Shares shares(progress);
    Chain chain{std::make_shared<const PointSet>(options.leftOut), {}};
    const PipelineState* state = nullptr;
    Eigen::Index root = 0;
    for (ChosenStep& choice : choicesUpTo(last, options, extent.scale)) {
      const Progress part = shares.next(*choice.step);
      if (choice.method->seesRoot) choice.root = root;
      chain.choices.push_back(std::move(choice));
      const PipelineState* known = states[chain.choices.size() - 1].find(chain);
      result.steps.push_back(recordOf(chain.choices.back(), known == nullptr));
      if (known == nullptr) {
        PipelineState next = state == nullptr ? firstState(cloud, options.leftOut) : *state;
        next.root = root;
        next.index = index;
        next.notes.clear();
        known = &computed(chain, std::move(next), part, watch);
      }
      state = known;
      result.steps.back().notes = state->notes;
      if (chain.choices.size() == 1) root = rootOf(chain, *state, options, extent.lowest);
    }
    result.contracted = state->contracted;
    result.skeleton = state->skeleton;
    result.radiusSources = state->radiusSources;
    progress.update(1);
    return result;
  }
};

std::vector<std::string> notesOf(const Reconstruction& reconstruction) {
  std::vector<std::string> notes;
  for (const StepRecord& record : reconstruction.steps)
    for (const std::string& note : record.notes)
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

Reconstruction Pipeline::runAtScale(const std::shared_ptr<const PointCloud>& cloud,
                                    const PlantScale& scale, const PipelineOptions& options,
                                    const Progress& progress, const std::string& last,
                                    const StepWatch& watch) {
  kept_->take(cloud, options);
  return kept_->run({.scale = scale}, {}, options, progress, last, watch);
}

} // namespace espalier
