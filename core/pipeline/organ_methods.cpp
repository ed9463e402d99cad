#include "core/clean/organs.h"
#include "core/cloud/repeated_points.h"
#include "core/pipeline/clean_parts.h"
#include "core/pipeline/methods.h"
#include "core/pipeline/organs_of_scan.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/step_graph.h"
#include "core/reconstruct/blade_midlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// What is left out: the place of a choice.
enum class LeftOutOrgans : std::uint8_t { foliage, blades, needles, all };

struct LeafOptions {
  LeftOutOrgans leaveOut = LeftOutOrgans::foliage;
};

bool isAmong(Organ organ, LeftOutOrgans organs) {
  switch (organs) {
  case LeftOutOrgans::foliage:
    return organ == Organ::blade || organ == Organ::needle;
  case LeftOutOrgans::blades:
    return organ == Organ::blade;
  case LeftOutOrgans::needles:
    return organ == Organ::needle;
  case LeftOutOrgans::all:
    return organ != Organ::wood;
  }
  return false;
}

/// @param byHand  how many of them were set by hand
ShownMessage noteOnShares(const std::vector<Organ>& organs, std::size_t byHand) {
  ShownMessage note{byHand == 0
                        ? Shown::tr("of %1 points, %2 % are of wood, %3 % of petioles, %4 % of "
                                    "blades and %5 % of needles")
                        : Shown::tr("of %1 points, %2 % are of wood, %3 % of petioles, %4 % of "
                                    "blades and %5 % of needles; %6 were set by hand"),
                    {std::to_string(organs.size())}};
  for (const Organ organ : allOrgans) {
    const double share = 100 * static_cast<double>(std::ranges::count(organs, organ)) /
                         static_cast<double>(organs.size());
    note.values.push_back(std::to_string(std::lround(share)));
  }
  note.values.push_back(std::to_string(byHand));
  return note;
}

std::optional<Eigen::Index> chosenRootAmong(const PipelineState& state,
                                            const StandingPoints& standing) {
  if (!state.chosenRoot) return std::nullopt;
  return nearestPoint(standing.positions, standing.fromFile(*state.chosenRoot).cast<float>());
}

/// Sets those of `organs` that were set by hand; one per column, which ascend.
/// @return how many
std::size_t takeMarks(const OrganMarks& marks, const std::vector<Eigen::Index>& columns,
                      std::vector<Organ>& organs) {
  std::size_t count = 0;
  if (columns.empty()) return 0;
  const PointSet known = PointSet::firstOf(columns.back() + 1); // marks know no size of the cloud
  for (const Organ organ : allOrgans)
    for (const Eigen::Index point : (marks.of(organ) & known).points()) {
      const auto at = std::ranges::lower_bound(columns, point);
      if (*at != point) continue;
      organs[static_cast<std::size_t>(at - columns.begin())] = organ;
      ++count;
    }
  return count;
}

/// The kept points of a scan with their organs, one per column; of too few points none.
struct ClassifiedPoints {
  std::vector<Eigen::Index> columns;
  std::vector<Organ> organs;
  std::size_t byHand = 0;
};

/// Leaves out the few points that lie far from all others.
ClassifiedPoints classified(PipelineState& state, const Progress& progress) {
  leaveOutFarPoints(state);
  const StandingPoints standing = standingOf(state);
  if (standing.columns.empty()) return {};
  const double spacing = pointSpacing(standing.positions, progress); // of these points alone
  if (!(spacing > 0)) return {};
  ClassifiedPoints result{
      .columns = standing.columns,
      .organs = organsAmong(standing.positions, chosenRootAmong(state, standing), spacing, progress)
                    .ofPoint};
  result.byHand = takeMarks(state.organs, result.columns, result.organs);
  return result;
}

void leaveOutLeaves(PipelineState& state, LeftOutOrgans which, const Progress& progress) {
  const auto [columns, organs, byHand] = classified(state, progress);
  if (columns.empty()) return;
  state.notes.push_back(noteOnShares(organs, byHand));
  std::vector<bool> isOut(organs.size());
  for (std::size_t i = 0; i < organs.size(); ++i)
    isOut[i] = isAmong(organs[i], which);
  constexpr std::ptrdiff_t fewest = 20; // points that may still be a plant
  if (std::ranges::count(isOut, false) < fewest) {
    state.notes.push_back({Shown::tr("no wood would be left: nothing is left out")});
    return;
  }
  leaveOut(state, columns, isOut);
  std::vector<Eigen::Index> blades;
  for (std::size_t i = 0; i < organs.size(); ++i)
    if (isOut[i] && organs[i] == Organ::blade) blades.push_back(columns[i]);
  state.blades = std::make_shared<const std::vector<Eigen::Index>>(std::move(blades));
}

Method shapesMethod() {
  OptionTable<LeafOptions> table;
  Option which = optionOf<OptionKind::choice>(
      "leave_out", Shown::tr("Leave out"), 0, 0,
      Shown::tr("Which organs are left out. Stems of herbs and grasses count as wood."));
  which.choices = {{"foliage", Shown::tr("Blades and needles")},
                   {"blades", Shown::tr("Blades")},
                   {"needles", Shown::tr("Needles")},
                   {"all", Shown::tr("All but wood")}};
  table.add(std::move(which), &LeafOptions::leaveOut);
  return {.name = "shapes",
          .label = Shown::tr("By shape"),
          .help = Shown::tr(
              "Classifies points as wood, petioles, blades and needles by the shapes around "
              "each point and by the paths to the root, and leaves out leaves."),
          .source = "shapes and paths as in M. B. Vicari et al., Methods Ecol. Evol. 10, 2019",
          .options = table.descriptions(),
          .seesRoot = true,
          .seesUp = true,
          .seesOrgans = true,
          .changesScale = true,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            leaveOutLeaves(state, table.with(values).leaveOut, progress);
          }};
}

void addMidlines(PipelineState& state, const MidlineOptions& options, const Progress& progress) {
  if (!state.blades) {
    state.notes.push_back({Shown::tr("no blades are known: turn on the step Leaves")});
    return;
  }
  Eigen::Matrix3Xd blades(3, std::ssize(*state.blades));
  for (Eigen::Index i = 0; i < blades.cols(); ++i)
    blades.col(i) = state.cloud->position((*state.blades)[static_cast<std::size_t>(i)]);
  state.setSkeleton(withMidlines(*state.skeleton, blades, options, progress));
}

Method midlineMethod() {
  using Options = MidlineOptions;
  OptionTable<Options> table;
  table.add(ratioOption("link", Shown::tr("Link"), 1, 100,
                        Shown::tr("Points of blades farther apart than this are of two blades, in "
                                  "point spacings of the blades.")),
            &Options::link);
  table.add(ratioOption("step", Shown::tr("Step"), 1, 100,
                        Shown::tr("Distance between the nodes of an axis, in point spacings of the "
                                  "blades.")),
            &Options::step);
  table.add(lengthOption("least_length", Shown::tr("Least length"), 1, 100000,
                         Shown::tr("Shorter pieces of blades get no axis.")),
            &Options::leastLength);
  table.add(lengthOption("widest_gap", Shown::tr("Widest gap"), 0, 100000,
                         Shown::tr("Blades farther from the wood than this get no axis.")),
            &Options::widestGap);
  return {.name = "midlines",
          .label = Shown::tr("Midlines"),
          .help = Shown::tr("Gives each blade that the step Leaves left out one axis, along its "
                            "midline."),
          .source = "level sets as in A. Verroust, F. Lazarus, The Visual Computer 16, 2000",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            addMidlines(state, table.with(values), progress);
          }};
}

} // namespace

std::vector<std::optional<Organ>> organsOfScan(const std::shared_ptr<const PointCloud>& cloud,
                                               const PipelineOptions& options,
                                               const Progress& progress) {
  requireKnown(options);
  std::vector<const Step*> before;
  for (const Step& step : pipelineSteps()) {
    if (step.name == "leaves") break;
    if (!isOff(step, withoutTrials(options))) before.push_back(&step);
  }
  PipelineState state = firstState(cloud, options);
  state.extent.scale = scaleOf(*cloud, options.leftOut, options.up, progress.part(0, 0.1));
  runCleaning(before, state, options, progress.part(0.1, 0.4));
  const ClassifiedPoints found = classified(state, progress.part(0.4, 1));
  std::vector<std::optional<Organ>> organs(static_cast<std::size_t>(cloud->size()));
  for (std::size_t i = 0; i < found.columns.size(); ++i)
    organs[static_cast<std::size_t>(found.columns[i])] = found.organs[i];
  forEachRepeated(
      *cloud,
      [&](Eigen::Index point) { return organs[static_cast<std::size_t>(point)].has_value(); },
      [&](Eigen::Index point, Eigen::Index like) {
        if (!options.leftOut.contains(point))
          organs[static_cast<std::size_t>(point)] = organs[static_cast<std::size_t>(like)];
      });
  return organs;
}

std::vector<Method> bladeMethods() {
  return {noMethod(Shown::tr("Gives blades no axes.")), midlineMethod()};
}

std::vector<Method> leafMethods() {
  return {noMethod(Shown::tr("Keeps leaves and needles.")), shapesMethod()};
}

} // namespace espalier
