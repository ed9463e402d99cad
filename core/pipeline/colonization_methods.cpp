#include "core/pipeline/colonization_methods.h"

#include "core/pipeline/method_parts.h"
#include "core/reconstruct/graph_colonization.h"
#include "core/reconstruct/point_tracking.h"
#include "core/reconstruct/space_colonization.h"

namespace espalier {
namespace {

Option leastStep(double count) {
  return {.name = "least_step",
          .label = "Least step",
          .kind = OptionKind::length,
          .rule = spacings(count),
          .minimum = 1,
          .maximum = 100,
          .help = "Distance between nodes where points are sparsest, as in twigs."};
}

Option greatestStep(double count) {
  return {.name = "greatest_step",
          .label = "Greatest step",
          .kind = OptionKind::length,
          .rule = spacings(count),
          .minimum = 1,
          .maximum = 200,
          .help = "Distance between nodes where points are densest, as in thick wood."};
}

Option reach(double steps) {
  return {.name = "reach",
          .label = "Reach",
          .kind = OptionKind::ratio,
          .rule = fixedAt(steps),
          .minimum = 1,
          .maximum = 10,
          .help = "How far from a node points pull at it, in steps; more bridges wider gaps."};
}

Option kill(double steps) {
  return {.name = "kill",
          .label = "Kill distance",
          .kind = OptionKind::ratio,
          .rule = fixedAt(steps),
          .minimum = 0.1,
          .maximum = 5,
          .help =
              "Points nearer to a node are done with, in steps; less finds more twigs, and more "
              "spurs."};
}

/// Those of the places that a skeleton is made of.
std::vector<float> placeDensities(const PipelineState& state, const Progress& progress) {
  return scannedDensities(*scannedIndex(state, keptPlaces(state), progress), progress);
}

} // namespace

Method graphColonizationMethod() {
  using Options = GraphColonizationOptions;
  OptionTable<Options> table;
  table.add(linksPerPoint(12), &Options::neighbors);
  table.add(leastStep(5), &Options::leastStep);
  table.add(greatestStep(8), &Options::greatestStep);
  table.add({.name = "junction_share",
             .label = "Junction share",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0),
             .minimum = 0,
             .maximum = 1,
             .help = "0 puts nodes in the middle of their points, 1 where these meet those of the "
                     "node before."},
            &Options::junctionShare);
  table.add(widestGap(), &Options::widestGap);
  return {.name = "graph_colonization",
          .label = "Graph colonization",
          .help = "Groups of points take the points behind them, in steps that follow the density.",
          .source = "PlantScan3D, after C. Preuksakarn, PhD thesis, Montpellier 2, 2012",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const std::vector<float> densities = placeDensities(state, progress.part(0, 0.2));
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonByGraphColonization(points, densities, root, table.with(values),
                                                 progress.part(0.2, 1));
            });
          }};
}

Method pointTrackingMethod() {
  using Options = PointTrackingOptions;
  OptionTable<Options> table;
  table.add(leastStep(5), &Options::leastStep);
  table.add(greatestStep(6), &Options::greatestStep);
  table.add(reach(3), &Options::reach);
  table.add(kill(1), &Options::kill);
  table.add({.name = "cone_angle",
             .label = "Cone angle",
             .kind = OptionKind::angle,
             .rule = fixedAt(45),
             .minimum = 10,
             .maximum = 80,
             .help =
                 "Opening of the cones in which a node looks for children; less separates narrower "
                 "forks apart."},
            &Options::coneAngle);
  table.add({.name = "fewest_points",
             .label = "Fewest points",
             .kind = OptionKind::count,
             .rule = fixedAt(3),
             .minimum = 1,
             .maximum = 100,
             .help = "Cones with fewer points bear no child."},
            &Options::fewestPoints);
  table.add({.name = "cluster_density",
             .label = "Cluster density",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0.5),
             .minimum = 0,
             .maximum = 1,
             .help = "Where points are denser than this share of the densest, directions are "
                     "clustered instead of sorted by cones; 1 is nowhere."},
            &Options::clusterDensity);
  table.add(thickWood(1), &Options::thickWood);
  table.add(widestGap(), &Options::widestGap);
  return {.name = "point_tracking",
          .label = "Point tracking",
          .help = "Follows the points from node to node, through cones, as the thesis does.",
          .source = "C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.7",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const std::vector<float> densities = placeDensities(state, progress.part(0, 0.2));
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonByPointTracking(points, densities, root, table.with(values),
                                             progress.part(0.2, 1));
            });
          }};
}

Method spaceColonizationMethod() {
  using Options = SpaceColonizationOptions;
  OptionTable<Options> table;
  table.add(leastStep(2), &Options::leastStep);
  table.add(greatestStep(3), &Options::greatestStep);
  table.add(reach(4), &Options::reach);
  table.add(kill(1.2), &Options::kill);
  table.add(thickWood(1), &Options::thickWood);
  table.add(widestGap(), &Options::widestGap);
  return {.name = "space_colonization",
          .label = "Space colonization",
          .help = "Points pull the nodes nearest to them; steps follow the density.",
          .source = "A. Runions, B. Lane, P. Prusinkiewicz, Eurographics Workshop on Natural "
                    "Phenomena, 2007",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const auto scanned = scannedIndex(state, keptPlaces(state), progress);
            const std::vector<float> densities = scannedDensities(*scanned, progress.part(0, 0.2));
            const bool isAsScanned = state.contracted.get() == &state.cloud->positions();
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonBySpaceColonization(points, densities, root, table.with(values),
                                                 progress.part(0.2, 1),
                                                 isAsScanned ? scanned.get() : nullptr);
            });
          }};
}

} // namespace espalier
