#include "core/pipeline/registry.h"

#include "core/base/shown_message.h"
#include "core/pipeline/methods.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace espalier {

namespace {

/// One that can be off, as all but Thin are by default. What lies around the plants goes first, the
/// largest first, so that what comes behind has less to look at and plants stand apart; then one
/// plant is chosen of what is left, thinned, and what stands alone in it goes last.
Step cleaningStep(const char* name, const char* label, const char* help,
                  std::vector<Method> methods) {
  return {.name = name,
          .label = label,
          .help = help,
          .takes = StepResult::scan,
          .makes = StepResult::cleaned,
          .isOptional = true,
          .share = 0.02,
          .methods = std::move(methods)};
}

} // namespace

const std::vector<Step>& pipelineSteps() {
  static const std::vector<Step> steps = {
      cleaningStep("crop", Shown::tr("Crop"), Shown::tr("Keeps a part of the scan."),
                   cropMethods()),
      cleaningStep("values", Shown::tr("Values"),
                   Shown::tr("Keeps points by their intensity or color."), valueMethods()),
      cleaningStep("ground", Shown::tr("Ground"), Shown::tr("Leaves out the ground."),
                   groundMethods()),
      cleaningStep("poles", Shown::tr("Poles"), Shown::tr("Leaves out poles and stakes."),
                   poleMethods()),
      cleaningStep("wires", Shown::tr("Wires"), Shown::tr("Leaves out wires and ropes."),
                   wireMethods()),
      cleaningStep("plant", Shown::tr("Plant"), Shown::tr("Keeps one of several plants."),
                   plantMethods()),
      cleaningStep("thin", Shown::tr("Thin"), Shown::tr("Keeps fewer points."), thinMethods()),
      cleaningStep("leaves", Shown::tr("Leaves"), Shown::tr("Leaves out leaves and needles."),
                   leafMethods()),
      {.name = "clean",
       .label = Shown::tr("Clean"),
       .help = Shown::tr("Leaves out points that are no plant."),
       .takes = StepResult::scan,
       .makes = StepResult::cleaned,
       .share = 0.1,
       .methods = cleanMethods()},
      {.name = "smooth",
       .label = Shown::tr("Smooth"),
       .help = Shown::tr("Moves the points to the surface of the wood that they sample."),
       .takes = StepResult::cleaned,
       .makes = StepResult::smoothed,
       .isOptional = true,
       .share = 0.2,
       .methods = smoothMethods()},
      {.name = "contract",
       .label = Shown::tr("Contract"),
       .help = Shown::tr("Pulls the points towards the axes of the plant."),
       .takes = StepResult::cleaned,
       .makes = StepResult::contracted,
       .share = 0.5,
       .methods = contractMethods()},
      {.name = "skeleton",
       .label = Shown::tr("Skeleton"),
       .help = Shown::tr("Finds nodes and their attachments."),
       .takes = StepResult::contracted,
       .share = 0.2,
       .methods = skeletonMethods()},
      {.name = "join",
       .label = Shown::tr("Join"),
       .help = Shown::tr("Chooses the attachments across gaps."),
       .share = 0.02,
       .methods = joinMethods()},
      {.name = "prune",
       .label = Shown::tr("Prune"),
       .help = Shown::tr("Removes what is no branch."),
       .share = 0.01,
       .methods = pruneMethods()},
      {.name = "axes",
       .label = Shown::tr("Axes"),
       .help = Shown::tr("Chooses which child continues the axis."),
       .share = 0.01,
       .methods = axesMethods()},
      {.name = "recenter",
       .label = Shown::tr("Recenter"),
       .help = Shown::tr("Moves nodes into the middle of the wood."),
       .share = 0.15,
       .methods = recenterMethods()},
      {.name = "insertions",
       .label = Shown::tr("Insertions"),
       .help = Shown::tr("Attaches branches where they leave the wood that bears them."),
       .share = 0.01,
       .methods = insertionMethods()},
      {.name = "ends",
       .label = Shown::tr("Ends"),
       .help = Shown::tr("Gives tips and roots their full length."),
       .share = 0.08,
       .methods = endsMethods()},
      {.name = "blades",
       .label = Shown::tr("Blades"),
       .help = Shown::tr("Draws axes of blades that were left out."),
       .isOptional = true,
       .share = 0.02,
       .methods = bladeMethods()},
      {.name = "nodes",
       .label = Shown::tr("Nodes"),
       .help = Shown::tr("Spaces the nodes."),
       .share = 0.01,
       .methods = nodeMethods()},
      {.name = "radius",
       .label = Shown::tr("Radius"),
       .help = Shown::tr("Gives each node its radius."),
       .makes = StepResult::radii,
       .share = 0.05,
       .methods = radiusMethods()},
  };
  return steps;
}

namespace {

template <class Named>
const Named* findNamed(const std::vector<Named>& all, std::string_view name) {
  const auto found = std::ranges::find(all, name, &Named::name);
  return found != all.end() ? &*found : nullptr;
}

template <class Named> std::string namesOfAll(const std::vector<Named>& all) {
  std::string names;
  for (const Named& each : all)
    names += (names.empty() ? "" : ", ") + each.name;
  return names;
}

} // namespace

const Step& contractionStep() {
  static const Step& step =
      *std::ranges::find(pipelineSteps(), StepResult::contracted, &Step::makes);
  return step;
}

const Step& cleaningStep() {
  static const Step& step = *std::prev(std::ranges::find_if_not(
      pipelineSteps(), [](StepResult made) { return made == StepResult::cleaned; }, &Step::makes));
  return step;
}

const Step& skeletonStep() {
  return *(&contractionStep() + 1);
}

const Step& stepNamed(std::string_view name) {
  if (const Step* step = findNamed(pipelineSteps(), name)) return *step;
  throw ShownError({espalier::Shown::tr("there is no step \"%1\": choose one of %2"),
                    {std::string(name), namesOfAll(pipelineSteps())}});
}

const Method& methodNamed(const Step& step, std::string_view name) {
  if (const Method* method = findNamed(step.methods, name)) return *method;
  throw ShownError({espalier::Shown::tr("there is no method \"%1\" for step %2: choose one of %3"),
                    {std::string(name), step.name, namesOfAll(step.methods)}});
}

} // namespace espalier
