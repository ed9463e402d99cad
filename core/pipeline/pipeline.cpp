#include "core/pipeline/pipeline.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <cmath>
#include <sstream>

namespace espalier {
namespace {

std::string optionNames(const Method& method) {
  std::string names;
  for (const Option& option : method.options)
    names += (names.empty() ? "" : ", ") + option.name;
  return names.empty() ? "it has none" : "choose one of " + names;
}

const Method& chosenMethod(const Step& step, const PipelineOptions& options) {
  const auto choice = options.methods.find(step.name);
  return choice == options.methods.end() ? step.methods.front() : methodNamed(step, choice->second);
}

void requireOption(const Step& step, const Method& method, const std::string& name) {
  for (const Option& option : method.options)
    if (option.name == name) return;
  throw Error("method " + method.name + " of step " + step.name + " has no option \"" + name +
              "\": " + optionNames(method));
}

double checkedValue(const Step& step, const Option& option, double value, const PlantScale& scale) {
  const auto [least, most] = option.range(scale);
  const bool isCounted = option.kind == OptionKind::count || option.takesWords();
  const bool isWhole = !isCounted || value == std::round(value);
  if (value >= least && value <= most && isWhole) return value;
  std::ostringstream text;
  if (option.takesWords()) {
    text << step.name << '.' << option.name << " takes no " << value << ": choose one of "
         << option.words();
    throw Error(text.str());
  }
  text << step.name << '.' << option.name << " is " << value << ": choose "
       << (option.kind == OptionKind::count ? "a whole number " : "a value ") << "from " << least
       << " to " << most;
  if (option.kind == OptionKind::length) text << " (the points are " << scale.spacing << " apart)";
  throw Error(text.str());
}

/// The option of that name of the method that is chosen, or else of another of the step. (Those of
/// one name take the same words: the method may be chosen later.)
const Option* optionNamed(const Step& step, const PipelineOptions& options,
                          const std::string& name) {
  const Option* found = nullptr;
  for (const Method& method : step.methods)
    for (const Option& option : method.options)
      if (option.name == name && (!found || &method == &chosenMethod(step, options)))
        found = &option;
  return found;
}

} // namespace

void PipelineOptions::set(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::size_t dot = assignment.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals)
    throw Error("\"" + assignment +
                "\" sets nothing: write STEP.OPTION=VALUE, such as "
                "contract.radius=12.5");
  const std::string step = assignment.substr(0, dot);
  const std::string option = assignment.substr(dot + 1, equals - dot - 1);
  const std::string text = assignment.substr(equals + 1);
  if (option == "method") {
    (void)methodNamed(stepNamed(step), text);
    methods[step] = text;
    return;
  }
  setText(stepNamed(step), option, text);
}

void PipelineOptions::setText(const Step& in, const std::string& option, const std::string& text) {
  const std::string& step = in.name;
  if (const Option* known = optionNamed(in, *this, option); known && known->takesWords()) {
    const std::optional<double> word = known->valueOf(text);
    if (!word)
      throw Error(step + "." + option + " takes no \"" + text + "\": choose one of " +
                  known->words());
    settings[step][option] = fixedAt(*word);
    return;
  }
  const Option* known = optionNamed(in, *this, option);
  const bool isLength = known == nullptr || known->kind == OptionKind::length;
  const std::optional<Rule> value = Rule::parse(text);
  if (!value || !(isLength || value->isFixed()))
    throw Error(step + "." + option + " must be a number" +
                (isLength ? ", or a length as '6 spacings' or '0.01 heights'" : "") + ", not " +
                inQuotes(text));
  settings[step][option] = *value;
}

void requireKnown(const PipelineOptions& options) {
  for (const auto& [name, method] : options.methods)
    (void)methodNamed(stepNamed(name), method);
  for (const auto& [name, values] : options.settings) {
    const Step& step = stepNamed(name);
    for (const auto& [option, value] : values)
      requireOption(step, chosenMethod(step, options), option);
  }
}

std::vector<double> resolvedValues(const Step& step, const Method& method,
                                   const PipelineOptions& options, const PlantScale& scale) {
  const auto settings = options.settings.find(step.name);
  std::vector<double> values;
  for (const Option& option : method.options) {
    double value = option.rule.value(scale);
    if (settings != options.settings.end())
      if (const auto set = settings->second.find(option.name); set != settings->second.end())
        value = checkedValue(step, option, set->second.value(scale), scale);
    values.push_back(value);
  }
  return values;
}

/// What the last run computed.
struct Pipeline::Kept {
  struct Result {
    std::string method;
    std::vector<double> values;
    PipelineState state;
  };
  std::shared_ptr<const PointCloud> cloud;
  std::optional<Eigen::Vector3d> root;
  UpAxis up = UpAxis::z;
  PointSet leftOut;
  PlantScale scale;
  std::vector<Result> results; // of the first steps

  /// @throws Error if the root that is asked for lies farther off than the plant is large
  void start(const std::shared_ptr<const PointCloud>& newCloud, const PipelineOptions& options,
             const Progress& progress) {
    if (options.root) {
      const Eigen::AlignedBox3d box = newCloud->bounds();
      const double away = box.exteriorDistance(*options.root);
      if (away > box.diagonal().norm())
        throw Error("the root lies " + plainDecimal(std::round(away)) +
                    " away from the scan: give a place in its coordinates");
    }
    if (cloud == newCloud && root == options.root && up == options.up && leftOut == options.leftOut)
      return;
    if (cloud != newCloud || up != options.up)
      scale = {pointSpacing(newCloud->positions(), progress),
               plantHeight(newCloud->positions(), options.up)};
    results.clear();
    cloud = newCloud;
    root = options.root;
    up = options.up;
    leftOut = options.leftOut;
  }

  [[nodiscard]] PipelineState firstState() const {
    std::vector<bool> isLeftOut(static_cast<std::size_t>(cloud->size()), true);
    for (const Eigen::Index kept : others(leftOut, cloud->size()))
      isLeftOut[static_cast<std::size_t>(kept)] = false;
    return {.cloud = cloud,
            .isLeftOut = std::move(isLeftOut),
            .contracted = std::make_shared<const Eigen::Matrix3Xf>(cloud->positions()),
            .root = 0,
            .skeleton = {},
            .radiusSources = {}};
  }

  /// The foot of the plant among the points that cleaning kept.
  [[nodiscard]] Eigen::Index rootPoint(const std::vector<bool>& isLeftOut) const {
    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0; i < cloud->size(); ++i)
      if (!isLeftOut[static_cast<std::size_t>(i)]) kept.push_back(i);
    if (kept.empty()) return 0;
    const Eigen::Matrix3Xf points = cloud->positions()(Eigen::all, kept);
    const Eigen::Index found =
        root ? nearestPoint(points, (*root - cloud->origin()).cast<float>()) : findRoot(points, up);
    return kept[static_cast<std::size_t>(found)];
  }
};

Pipeline::Pipeline() : kept_(std::make_unique<Kept>()) {}
Pipeline::~Pipeline() = default;
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&&) noexcept = default;

Reconstruction Pipeline::run(const std::shared_ptr<const PointCloud>& cloud,
                             const PipelineOptions& options, const Progress& progress,
                             const std::string& last) {
  requireKnown(options);
  if (cloud->size() < 2) throw Error("a plant needs at least 2 points: check the scan");
  kept_->start(cloud, options, progress);
  if (kept_->scale.spacing == 0)
    throw Error("all points of the scan are at the same place: check the scan");

  Reconstruction result;
  result.scale = kept_->scale;
  double total = 0;
  for (const Step& step : pipelineSteps())
    total += step.share;
  double done = 0;
  for (std::size_t i = 0; i < pipelineSteps().size(); ++i) {
    const Step& step = pipelineSteps()[i];
    const Method& method = chosenMethod(step, options);
    const std::vector<double> values = resolvedValues(step, method, options, kept_->scale);
    std::vector<Kept::Result>& results = kept_->results;
    const bool isAtHand =
        i < results.size() && results[i].method == method.name && results[i].values == values;
    if (!isAtHand) {
      results.resize(std::min(i, results.size()));
      PipelineState state = i == 0 ? kept_->firstState() : results[i - 1].state;
      method.run(state, values, progress.part(done, done + step.share / total, step.label));
      if (step.name == "clean") state.root = kept_->rootPoint(state.isLeftOut);
      results.push_back({method.name, values, std::move(state)});
    }
    done += step.share / total;
    StepRecord record{.step = step.name, .method = method.name, .values = {}, .isNew = !isAtHand};
    for (std::size_t v = 0; v < values.size(); ++v)
      record.values.emplace_back(method.options[v].name, values[v]);
    result.steps.push_back(std::move(record));
    if (step.name == last) break;
  }
  const PipelineState& end = kept_->results[result.steps.size() - 1].state;
  result.contracted = end.contracted;
  result.skeleton = end.skeleton;
  result.radiusSources = end.radiusSources;
  progress.update(1);
  return result;
}

} // namespace espalier
