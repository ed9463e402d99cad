#include "core/pipeline/path_methods.h"

#include "core/pipeline/method_parts.h"
#include "core/reconstruct/branch_structure_graph.h"
#include "core/reconstruct/shortest_path_skeleton.h"

namespace espalier {
namespace {

Option spacing() {
  return {.name = "spacing",
          .label = "Spacing",
          .kind = OptionKind::length,
          .rule = spacings(6),
          .minimum = 1,
          .maximum = 100,
          .help = "Greatest distance between nodes."};
}

} // namespace

Method shortestPathMethod() {
  using Options = ShortestPathOptions;
  OptionTable<Options> table;
  table.add(linksPerPoint(16), &Options::neighbors);
  table.add({.name = "power",
             .label = "Power",
             .kind = OptionKind::ratio,
             .rule = fixedAt(2),
             .minimum = 1,
             .maximum = 4,
             .help = "A link costs its length to this power; more avoids leaps over gaps."},
            &Options::power);
  table.add({.name = "least_share",
             .label = "Least share",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0.019),
             .minimum = 0,
             .maximum = 1,
             .help = "Branches go whose longest path is a smaller share of that of their wood."},
            &Options::leastShare);
  table.add(spacing(), &Options::spacing);
  table.add({.name = "merge_angle",
             .label = "Merge angle",
             .kind = OptionKind::angle,
             .rule = fixedAt(25),
             .minimum = 0,
             .maximum = 90,
             .help = "Branches side by side at less than this may be one."},
            &Options::mergeAngle);
  table.add({.name = "least_radius",
             .label = "Least radius",
             .kind = OptionKind::length,
             .rule = spacings(2),
             .minimum = 0.1,
             .maximum = 50,
             .help = "How far points lie off the axis even of a twig; more merges more."},
            &Options::leastRadius);
  table.add(thickWood(1), &Options::thickWood);
  table.add(widestGap(), &Options::widestGap);
  return {.name = "shortest_paths",
          .label = "Shortest paths",
          .help = "Simplifies the tree of shortest paths, by squared length, over all points.",
          .source = "S. Du et al. (AdTree), Remote Sensing 11(18), 2019",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonByShortestPaths(points, root, table.with(values), progress);
            });
          }};
}

Method branchStructureMethod() {
  using Options = BranchStructureOptions;
  OptionTable<Options> table;
  table.add(linksPerPoint(7), &Options::neighbors);
  table.add({.name = "rounds",
             .label = "Rounds",
             .kind = OptionKind::count,
             .rule = fixedAt(3),
             .minimum = 0,
             .maximum = 50,
             .help = "How often branches are made straighter."},
            &Options::rounds);
  table.add({.name = "radius_share",
             .label = "Radius share",
             .kind = OptionKind::ratio,
             .rule = fixedAt(1),
             .minimum = 0.001,
             .maximum = 100,
             .help =
                 "Mean radius of the wood, in mean distances of the points from it; more merges "
                 "more."},
            &Options::radiusShare);
  table.add({.name = "least_edge",
             .label = "Least edge",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0.15),
             .minimum = 0,
             .maximum = 1,
             .help = "Shorter edges go; 0 is the shortest, 1 the longest of all."},
            &Options::leastEdge);
  table.add({.name = "overlap",
             .label = "Overlap",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0.5),
             .minimum = 0.01,
             .maximum = 1,
             .help = "Branches whose wood overlaps by more than this share become one."},
            &Options::overlap);
  table.add(spacing(), &Options::spacing);
  table.add(thickWood(1), &Options::thickWood);
  table.add(widestGap(), &Options::widestGap);
  return {.name = "branch_structure",
          .label = "Branch structure graph",
          .help =
              "Straightens the tree of shortest paths over all points, and merges what overlaps.",
          .source = "Y. Livny et al., ACM Trans. Graph. 29(6), 2010",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonByBranchStructure(points, root, table.with(values), progress);
            });
          }};
}

} // namespace espalier
