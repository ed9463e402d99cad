#include "core/pipeline/method_parts.h"
#include "core/pipeline/methods.h"
#include "core/reconstruct/graph_colonization.h"
#include "core/reconstruct/point_tracking.h"
#include "core/reconstruct/space_colonization.h"

namespace espalier {
namespace {

Option leastStepOption() {
  return lengthOption("least_step", Shown::tr("Least step"), 1, 100,
                      Shown::tr("Distance between nodes where points are sparsest, as in twigs."));
}

Option greatestStepOption() {
  return lengthOption(
      "greatest_step", Shown::tr("Greatest step"), 1, 200,
      Shown::tr("Distance between nodes where points are densest, as in thick wood."));
}

Option reachOption() {
  return ratioOption(
      "reach", Shown::tr("Reach"), 1, 10,
      Shown::tr("How far from a node points pull at it, in steps; more bridges wider gaps."));
}

Option killOption() {
  return ratioOption(
      "kill", Shown::tr("Kill distance"), 0.1, 5,
      Shown::tr("Points nearer to a node are done with, in steps; less finds more twigs, and more "
                "spurs."));
}

Option clusteredOption() {
  Option option = optionOf<OptionKind::choice>(
      "clustered", Shown::tr("What is clustered"), 0, 0,
      Shown::tr("Directions lead from the node to its points; orientations are how the wood runs "
                "at each of these, as in the thesis."));
  option.choices = {{"directions", Shown::tr("Directions")},
                    {"orientations", Shown::tr("Orientations")}};
  return option;
}

/// Options of a method whose steps follow the density.
template <class Options> struct ByDensity : Options {
  DensityMeasure measure = DensityMeasure::range;
};

/// Those of the places that a skeleton is made of.
std::vector<float> placeDensities(const PipelineState& state, DensityMeasure measure,
                                  const Progress& progress) {
  return scannedDensities(*scannedIndex(state, keptPlaces(state), progress), measure, progress);
}

} // namespace

Method graphColonizationMethod() {
  using Options = ByDensity<GraphColonizationOptions>;
  OptionTable<Options> table;
  table.add(linksOverGapsOption(), &Options::neighbors, &PointLinks::count);
  table.add(leastStepOption(), &Options::leastStep);
  table.add(greatestStepOption(), &Options::greatestStep);
  table.add(densityMeasureOption(), &Options::measure);
  table.add(
      ratioOption(
          "junction_share", Shown::tr("Junction share"), 0, 1,
          Shown::tr("0 puts nodes in the middle of their points, 1 where these meet those of the "
                    "node before.")),
      &Options::junctionShare);
  table.add(widestGapOption(), &Options::widestGap);
  table.add(linkKindOption(), &Options::neighbors, &PointLinks::kind);
  return {.name = "graph_colonization",
          .label = Shown::tr("Graph colonization"),
          .help = Shown::tr(
              "Groups of points take the points behind them, in steps that follow the density."),
          .inManual = Shown::tr(
              "lets each piece take the points behind it, far in thick wood, near in twigs"),
          .source = "PlantScan3D, after C. Preuksakarn, PhD thesis, Montpellier 2, 2012",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const Options options = table.with(values);
            const std::vector<float> densities =
                placeDensities(state, options.measure, progress.part(0, 0.2));
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonByGraphColonization(points, densities, root, options,
                                                 progress.part(0.2, 1));
            });
          }};
}

Method pointTrackingMethod() {
  using Options = ByDensity<PointTrackingOptions>;
  OptionTable<Options> table;
  table.add(leastStepOption(), &Options::leastStep);
  table.add(greatestStepOption(), &Options::greatestStep);
  table.add(densityMeasureOption(), &Options::measure);
  table.add(reachOption(), &Options::reach);
  table.add(killOption(), &Options::kill);
  table.add(
      angleOption(
          "cone_angle", Shown::tr("Cone angle"), 10, 80,
          Shown::tr(
              "Opening of the cones in which a node looks for children; less separates narrower "
              "forks apart.")),
      &Options::coneAngle);
  table.add(countOption("fewest_points", Shown::tr("Fewest points"), 1, 100,
                        Shown::tr("Cones with fewer points bear no child.")),
            &Options::fewestPoints);
  table.add(ratioOption(
                "cluster_density", Shown::tr("Cluster density"), 0, 1,
                Shown::tr("Where points are denser than this share of the densest, directions are "
                          "clustered instead of sorted by cones; 1 is nowhere.")),
            &Options::clusterDensity);
  table.add(clusteredOption(), &Options::clustered);
  table.add(thickWoodOption(), &Options::thickWood);
  table.add(widestGapOption(), &Options::widestGap);
  return {
      .name = "point_tracking",
      .label = Shown::tr("Point tracking"),
      .help = Shown::tr("Follows the points from node to node, through cones, as the thesis does."),
      .inManual = Shown::tr("follows the points from node to node, through cones, or by clusters "
                            "of directions where points are dense"),
      .source = "C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.7",
      .options = table.descriptions(),
      .run =
          [table](PipelineState& state, const Values& values, const Progress& progress) {
            const Options options = table.with(values);
            const std::vector<float> densities =
                placeDensities(state, options.measure, progress.part(0, 0.2));
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonByPointTracking(points, densities, root, options,
                                             progress.part(0.2, 1));
            });
          },
      .probe =
          [table](const Values& values) {
            const Options options = table.with(values);
            return MethodProbe{.cones = ConeProbe{.angle = options.coneAngle,
                                                  .length =
                                                      [options](double density) {
                                                        const double step =
                                                            options.leastStep +
                                                            density * (options.greatestStep -
                                                                       options.leastStep);
                                                        return options.reach * step;
                                                      },
                                                  .measure = options.measure}};
          }};
}

Method spaceColonizationMethod() {
  using Options = ByDensity<SpaceColonizationOptions>;
  OptionTable<Options> table;
  table.add(leastStepOption(), &Options::leastStep);
  table.add(greatestStepOption(), &Options::greatestStep);
  table.add(densityMeasureOption(), &Options::measure);
  table.add(reachOption(), &Options::reach);
  table.add(killOption(), &Options::kill);
  table.add(thickWoodOption(), &Options::thickWood);
  table.add(widestGapOption(), &Options::widestGap);
  return {.name = "space_colonization",
          .label = Shown::tr("Space colonization"),
          .help = Shown::tr("Points pull the nodes nearest to them; steps follow the density."),
          .inManual = Shown::tr("lets the points pull the nodes nearest to them"),
          .source = "A. Runions, B. Lane, P. Prusinkiewicz, Eurographics Workshop on Natural "
                    "Phenomena, 2007",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const auto scanned = scannedIndex(state, keptPlaces(state), progress);
            const Options options = table.with(values);
            const std::vector<float> densities =
                scannedDensities(*scanned, options.measure, progress.part(0, 0.2));
            const bool isAsScanned = state.contracted.get() == &state.cloud->positions();
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonBySpaceColonization(points, densities, root, options,
                                                 progress.part(0.2, 1),
                                                 isAsScanned ? scanned.get() : nullptr);
            });
          }};
}

} // namespace espalier
