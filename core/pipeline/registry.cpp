#include "core/pipeline/registry.h"

#include "core/base/error.h"
#include "core/cloud/isolated_points.h"
#include "core/contract/geodesic_centroid.h"
#include "core/radius/measured_radii.h"
#include "core/radius/node_count_pipe_model.h"
#include "core/reconstruct/geodesic_bins.h"
#include "core/skeleton/assemble_axes.h"
#include "core/skeleton/extend_ends.h"
#include "core/skeleton/prune.h"
#include "core/skeleton/recenter.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

using Values = std::vector<double>;

Method nothing(std::string help) {
  return {.name = "none",
          .label = "None",
          .help = std::move(help),
          .source = {},
          .options = {},
          .run = [](PipelineState&, const Values&, const Progress&) {}};
}

std::vector<Eigen::Index> keptPoints(const PipelineState& state) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < state.cloud->size(); ++i)
    if (!state.isLeftOut[static_cast<std::size_t>(i)]) kept.push_back(i);
  return kept;
}

Eigen::Matrix3Xf keptPositions(const PipelineState& state) {
  return state.cloud->positions()(Eigen::all, keptPoints(state));
}

void requirePlant(const std::vector<Eigen::Index>& kept) {
  if (kept.size() < 2)
    throw Error("fewer than 2 points are left after cleaning: clean less, or choose method none");
}

Method isolatedPointsMethod() {
  using Options = IsolatedPointOptions;
  OptionTable<Options> table;
  table.add({.name = "neighbors",
             .label = "Neighbors",
             .kind = OptionKind::count,
             .rule = fixedAt(8),
             .minimum = 1,
             .maximum = 64,
             .help = "How many of the nearest points are looked at."},
            &Options::neighbors);
  table.add(
      {.name = "distance",
       .label = "Distance",
       .kind = OptionKind::length,
       .rule = spacings(8),
       .minimum = 0.5,
       .maximum = 100,
       .help = "A point is left out if its neighbors are farther away than this in the mean."},
      &Options::distance);
  return {.name = "isolated_points",
          .label = "Leave out isolated points",
          .help = "Leaves out points that stand alone, as dust and split laser beams do.",
          .source = "as in statistical outlier removal, with a distance in point spacings",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            state.isLeftOut =
                isolatedPoints(state.cloud->positions(), table.with(values), progress);
          }};
}

Method geodesicCentroidMethod() {
  using Options = GeodesicCentroidOptions;
  OptionTable<Options> table;
  table.add({.name = "neighbors",
             .label = "Neighbors",
             .kind = OptionKind::count,
             .rule = fixedAt(7),
             .minimum = 3,
             .maximum = 64,
             .help = "Links per point along which distances are measured."},
            &Options::neighbors);
  table.add({.name = "radius",
             .label = "Radius",
             .kind = OptionKind::length,
             .rule = spacings(7.5),
             .minimum = 1,
             .maximum = 60,
             .help = "Each point moves to the mean of the points within this distance along the "
                     "plant. More than the radius of the thickest wood blurs twigs."},
            &Options::radius);
  return {.name = "geodesic_centroid",
          .label = "Geodesic centroids",
          .help = "Moves each point to the mean of the points near it along the plant.",
          .source = "C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.6",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const std::vector<Eigen::Index> kept = keptPoints(state);
            requirePlant(kept);
            Eigen::Matrix3Xf positions = state.cloud->positions();
            positions(Eigen::all, kept) = contractedToGeodesicCentroids(
                positions(Eigen::all, kept), table.with(values), progress);
            state.contracted = std::make_shared<const Eigen::Matrix3Xf>(std::move(positions));
          }};
}

Method geodesicBinsMethod() {
  using Options = GeodesicBinOptions;
  OptionTable<Options> table;
  table.add({.name = "neighbors",
             .label = "Neighbors",
             .kind = OptionKind::count,
             .rule = fixedAt(12),
             .minimum = 3,
             .maximum = 64,
             .help = "Links per point along which distances are measured; more bridge wider gaps."},
            &Options::neighbors);
  table.add(
      {.name = "bin_width",
       .label = "Bin width",
       .kind = OptionKind::length,
       .rule = spacings(6),
       .minimum = 1,
       .maximum = 100,
       .help = "Distance between nodes along the plant. Less finds more twigs, and more spurs."},
      &Options::binWidth);
  table.add({.name = "widest_gap",
             .label = "Widest gap",
             .kind = OptionKind::length,
             .rule = fixedAt(0),
             .minimum = 0,
             .maximum = 10000,
             .help = "Parts of the plant farther apart than this are not joined; 0 joins all."},
            &Options::widestGap);
  return {.name = "geodesic_bins",
          .label = "Geodesic bins",
          .help = "One node per connected part of each bin of the distance to the root.",
          .source = "H. Xu, N. Gossett, B. Chen, ACM Trans. Graph. 26(4), 2007",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const std::vector<Eigen::Index> kept = keptPoints(state);
            requirePlant(kept);
            const auto place = std::lower_bound(kept.begin(), kept.end(), state.root);
            const Eigen::Matrix3Xf points = (*state.contracted)(Eigen::all, kept);
            Skeleton local =
                skeletonByGeodesicBins(points, place - kept.begin(), table.with(values), progress);
            for (const NodeId id : local.ids())
              local.setPosition(id, local[id].position + state.cloud->origin());
            state.skeleton = std::move(local);
          }};
}

Method spurMethod() {
  using Options = SpurOptions;
  OptionTable<Options> table;
  table.add({.name = "length",
             .label = "Length",
             .kind = OptionKind::length,
             .rule = spacings(14),
             .minimum = 0,
             .maximum = 200,
             .help = "Unbranched ends shorter than this are removed."},
            &Options::length);
  table.add({.name = "radius_share",
             .label = "Radius share",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0),
             .minimum = 0,
             .maximum = 10,
             .help = "This many radii of the wood they stand on are added to that length."},
            &Options::radiusShare);
  return {.name = "spurs",
          .label = "Remove spurs",
          .help = "Removes short unbranched ends, shortest first.",
          .source = {},
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            state.skeleton = withoutSpurs(state.skeleton, table.with(values), progress);
          }};
}

Method recenterMethod() {
  using Options = RecenterOptions;
  OptionTable<Options> table;
  table.add({.name = "rounds",
             .label = "Rounds",
             .kind = OptionKind::count,
             .rule = fixedAt(1),
             .minimum = 0,
             .maximum = 20,
             .help = "How often nodes are moved and smoothed."},
            &Options::rounds);
  table.add({.name = "smoothing",
             .label = "Smoothing",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0.2),
             .minimum = 0,
             .maximum = 1,
             .help = "Share of the way each node moves to the mean of its neighbors on the axis."},
            &Options::smoothing);
  table.add({.name = "least_coverage",
             .label = "Least coverage",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0.6),
             .minimum = 0.1,
             .maximum = 1,
             .help = "Share of a circle that points must cover before a fitted circle is trusted."},
            &Options::leastCoverage);
  return {
      .name = "sections",
      .label = "Recenter on sections",
      .help =
          "Moves nodes to the centers of circles fitted to the wood around them and smooths the "
          "axes.",
      .source = "circle: G. Taubin, IEEE PAMI 13, 1991",
      .options = table.descriptions(),
      .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
        state.skeleton = recentered(state.skeleton, keptPositions(state), state.cloud->origin(),
                                    table.with(values), progress);
      }};
}

Method endsMethod() {
  return {.name = "to_points",
          .label = "Extend to the points",
          .help = "Lengthens tips and roots to the points that contraction pulled inwards.",
          .source = {},
          .options = {},
          .run = [](PipelineState& state, const Values&, const Progress& progress) {
            state.skeleton = withExtendedEnds(state.skeleton, keptPositions(state),
                                              state.cloud->origin(), progress);
          }};
}

Method axesMethod() {
  using Options = AxisOptions;
  OptionTable<Options> table;
  table.add({.name = "sharpest_turn",
             .label = "Sharpest turn",
             .kind = OptionKind::angle,
             .rule = fixedAt(60),
             .minimum = 1,
             .maximum = 180,
             .help = "An axis never turns more than this at a node."},
            &Options::sharpestTurn);
  table.add({.name = "reach",
             .label = "Reach",
             .kind = OptionKind::count,
             .rule = fixedAt(4),
             .minimum = 1,
             .maximum = 50,
             .help = "Edges before and behind a node over which its turn is measured."},
            &Options::reach);
  return {.name = "heaviest_child",
          .label = "Heaviest child",
          .help =
              "The child that carries most continues the axis, unless it turns off too sharply.",
          .source = "PlantScan3D's rule, by length instead of node count",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            state.skeleton = withAssembledAxes(state.skeleton, table.with(values));
          }};
}

Method nodeCountPipeMethod() {
  return {.name = "node_count_pipe",
          .label = "Node-count pipe model",
          .help = "Radii grow with the number of nodes carried, between those measured at the foot "
                  "and at the tips.",
          .source = "law of the structures published with the thesis of C. Preuksakarn, 2012",
          .options = {},
          .run = [](PipelineState& state, const Values&, const Progress& progress) {
            const std::vector<double> measured = meanPointDistances(
                state.skeleton, keptPositions(state), state.cloud->origin(), progress);
            state.skeleton =
                withNodeCountPipeRadii(state.skeleton, pipeEndRadii(state.skeleton, measured));
          }};
}

} // namespace

const std::vector<Step>& pipelineSteps() {
  static const std::vector<Step> steps = {
      {.name = "clean",
       .label = "Clean",
       .help = "Leaves out points that are no plant.",
       .share = 0.1,
       .methods = {isolatedPointsMethod(), nothing("Keeps all points.")}},
      {.name = "contract",
       .label = "Contract",
       .help = "Pulls the points towards the axes of the plant.",
       .share = 0.5,
       .methods = {geodesicCentroidMethod(), nothing("Leaves the points where they are.")}},
      {.name = "skeleton",
       .label = "Skeleton",
       .help = "Finds nodes and what hangs on what.",
       .share = 0.2,
       .methods = {geodesicBinsMethod()}},
      {.name = "prune",
       .label = "Prune",
       .help = "Removes what is no branch.",
       .share = 0.01,
       .methods = {spurMethod(), nothing("Keeps all branches.")}},
      {.name = "axes",
       .label = "Axes",
       .help = "Chooses which child continues the axis.",
       .share = 0.01,
       .methods = {axesMethod()}},
      {.name = "recenter",
       .label = "Recenter",
       .help = "Moves nodes into the middle of the wood.",
       .share = 0.15,
       .methods = {recenterMethod(), nothing("Leaves the nodes where they are.")}},
      {.name = "ends",
       .label = "Ends",
       .help = "Gives tips and roots their full length.",
       .share = 0.08,
       .methods = {endsMethod(), nothing("Leaves the ends where they are.")}},
      {.name = "radius",
       .label = "Radius",
       .help = "Gives each node its radius.",
       .share = 0.05,
       .methods = {nodeCountPipeMethod()}},
  };
  return steps;
}

namespace {

/// The named one of `all`; an Error that lists them otherwise.
template <class Named>
const Named& findNamed(const std::vector<Named>& all, std::string_view name,
                       const std::string& what, const std::string& where = {}) {
  std::string names;
  for (const Named& each : all) {
    if (each.name == name) return each;
    names += (names.empty() ? "" : ", ") + each.name;
  }
  throw Error("there is no " + what + " \"" + std::string(name) + "\"" + where +
              ": choose one of " + names);
}

} // namespace

const Step& stepNamed(std::string_view name) {
  return findNamed(pipelineSteps(), name, "step");
}

const Method& methodNamed(const Step& step, std::string_view name) {
  return findNamed(step.methods, name, "method", " for step " + step.name);
}

} // namespace espalier
