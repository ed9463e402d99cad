#include "core/clean/outliers.h"
#include "core/clean/parts.h"
#include "core/cloud/isolated_points.h"
#include "core/pipeline/clean_parts.h"
#include "core/pipeline/methods.h"

namespace espalier {
namespace {

Option nearestOption() {
  return countOption("neighbors", Shown::tr("Neighbors"), 1, 64,
                     Shown::tr("How many of the nearest points are looked at."));
}

Method isolatedPointsMethod() {
  using Options = IsolatedPointOptions;
  OptionTable<Options> table;
  table.add(nearestOption(), &Options::neighbors);
  table.add(
      lengthOption(
          "distance", Shown::tr("Distance"), 0.5, 100,
          Shown::tr(
              "A point is left out if its neighbors are farther away than this in the mean.")),
      &Options::distance);
  return {.name = "isolated_points",
          .label = Shown::tr("Leave out isolated points"),
          .help = Shown::tr(
              "Leaves out points that stand alone, as dust and split laser beams do, and the few "
              "that lie far from the plant."),
          .source = "as in statistical outlier removal, with a distance in point spacings",
          .options = table.descriptions(),
          .seesRoot = false,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            leaveOutFarPoints(state);
            const std::vector<Eigen::Index> kept = keptPoints(state);
            leaveOut(
                state, kept,
                isolatedPoints(*scannedIndex(state, kept, progress), table.with(values), progress));
          }};
}

Method outliersMethod() {
  using Options = OutlierOptions;
  OptionTable<Options> table;
  table.add(nearestOption(), &Options::neighbors);
  table.add(ratioOption("deviations", Shown::tr("Deviations"), 0, 20,
                        Shown::tr("A point is left out if its neighbors are farther away in the "
                                  "mean than those of others, by so many standard deviations.")),
            &Options::deviations);
  return {.name = "outliers",
          .label = Shown::tr("Leave out statistical outliers"),
          .help = Shown::tr("Leaves out points whose neighbors are farther away than those of "
                            "most points."),
          .source = "R. B. Rusu et al., Robotics and Autonomous Systems 56, 2008",
          .options = table.descriptions(),
          .seesRoot = false,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            leaveOutFarPoints(state);
            const std::vector<Eigen::Index> kept = keptPoints(state);
            leaveOut(state, kept,
                     statisticalOutliers(*scannedIndex(state, kept, progress), table.with(values),
                                         progress));
          }};
}

Method sparseMethod() {
  using Options = SparsePointOptions;
  OptionTable<Options> table;
  table.add(nearestOption(), &Options::neighbors);
  table.add(
      ratioOption("share", Shown::tr("Share"), 0, 0.99,
                  Shown::tr("Share of the points that is left out, those that lie thinnest.")),
      &Options::share);
  return {.name = "density",
          .label = Shown::tr("Leave out the thinnest points"),
          .help = Shown::tr("Leaves out the share of the points that lie thinnest, by the distance "
                            "to their neighbors."),
          .source = "percentile of the distance to the k-th neighbor",
          .options = table.descriptions(),
          .seesRoot = false,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            leaveOutFarPoints(state);
            const std::vector<Eigen::Index> kept = keptPoints(state);
            leaveOut(
                state, kept,
                sparsestPoints(*scannedIndex(state, kept, progress), table.with(values), progress));
          }};
}

Method partsMethod() {
  using Options = PartOptions;
  OptionTable<Options> table;
  Option keep = optionOf<OptionKind::choice>(
      "keep", Shown::tr("Keep"), 0, 0,
      Shown::tr("Which parts stay. The rooted one is that nearest to the root that was chosen; "
                "without one, the largest."));
  keep.choices = {{"largest", Shown::tr("The largest")},
                  {"rooted", Shown::tr("The rooted one")},
                  {"large", Shown::tr("All large ones")}};
  table.add(std::move(keep), &Options::keep);
  table.add(lengthOption("widest_gap", Shown::tr("Widest gap"), 0.5, 10000,
                         Shown::tr("Points farther apart than this are of different parts.")),
            &Options::widestGap);
  table.add(countOption("least_points", Shown::tr("Least points"), 1, 100000000,
                        Shown::tr("Parts of fewer points are left out, where all large ones "
                                  "stay.")),
            &Options::leastPoints);
  return {.name = "parts",
          .label = Shown::tr("Leave out loose parts"),
          .help = Shown::tr("Keeps the parts that are large, or one of them, and leaves out what "
                            "is not connected with it."),
          .source = "connected components of a neighborhood graph",
          .options = table.descriptions(),
          .seesRoot = true,
          .changesScale = true,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            leaveOutFarPoints(state);
            const std::vector<Eigen::Index> kept = keptPoints(state);
            std::optional<Eigen::Vector3f> root;
            if (state.chosenRoot) root = (*state.chosenRoot - state.cloud->origin()).cast<float>();
            leaveOut(state, kept,
                     outsideParts(state.cloud->positions()(Eigen::all, kept), root,
                                  table.with(values), progress));
          }};
}

} // namespace

std::vector<Method> cleanMethods() {
  return {isolatedPointsMethod(), outliersMethod(), sparseMethod(), partsMethod(),
          noMethod(Shown::tr("Keeps all points."))};
}

} // namespace espalier
