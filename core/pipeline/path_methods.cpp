#include "core/pipeline/method_parts.h"
#include "core/pipeline/methods.h"
#include "core/reconstruct/branch_structure_graph.h"
#include "core/reconstruct/shortest_path_skeleton.h"

namespace espalier {
namespace {

Option spacingOption() {
  return lengthOption("spacing", Shown::tr("Spacing"), 1, 100,
                      Shown::tr("Greatest distance between nodes."));
}

} // namespace

Method shortestPathMethod() {
  using Options = ShortestPathOptions;
  OptionTable<Options> table;
  table.add(linksOverGapsOption(), &Options::neighbors, &PointLinks::count);
  table.add(
      ratioOption("power", Shown::tr("Power"), 1, 4,
                  Shown::tr("A link costs its length to this power; more avoids leaps over gaps.")),
      &Options::power);
  table.add(
      ratioOption(
          "least_share", Shown::tr("Least share"), 0, 1,
          Shown::tr("Branches go whose longest path is a smaller share of that of their wood.")),
      &Options::leastShare);
  table.add(spacingOption(), &Options::spacing);
  table.add(angleOption("merge_angle", Shown::tr("Merge angle"), 0, 90,
                        Shown::tr("Branches side by side at less than this may be one.")),
            &Options::mergeAngle);
  table.add(
      lengthOption("least_radius", Shown::tr("Least radius"), 0.1, 50,
                   Shown::tr("How far points lie off the axis even of a twig; more merges more.")),
      &Options::leastRadius);
  table.add(thickWoodOption(), &Options::thickWood);
  table.add(widestGapOption(), &Options::widestGap);
  table.add(linkKindOption(), &Options::neighbors, &PointLinks::kind);
  return {.name = "shortest_paths",
          .label = Shown::tr("Shortest paths"),
          .help = Shown::tr(
              "Simplifies the tree of shortest paths, by squared length, over all points."),
          .inManual = Shown::tr("simplifies the tree of shortest paths over all points"),
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
  table.add(linksOverGapsOption(), &Options::neighbors, &PointLinks::count);
  table.add(countOption("rounds", Shown::tr("Rounds"), 0, 50,
                        Shown::tr("How often branches are made straighter.")),
            &Options::rounds);
  table.add(
      ratioOption(
          "radius_share", Shown::tr("Radius share"), 0.001, 100,
          Shown::tr("Mean radius of the wood, in mean distances of the points from it; more merges "
                    "more.")),
      &Options::radiusShare);
  table.add(ratioOption("least_edge", Shown::tr("Least edge"), 0, 1,
                        Shown::tr("Shorter edges go; 0 is the shortest, 1 the longest of all.")),
            &Options::leastEdge);
  table.add(
      ratioOption("overlap", Shown::tr("Overlap"), 0.01, 1,
                  Shown::tr("Branches whose wood overlaps by more than this share become one.")),
      &Options::overlap);
  table.add(spacingOption(), &Options::spacing);
  table.add(thickWoodOption(), &Options::thickWood);
  table.add(widestGapOption(), &Options::widestGap);
  table.add(linkKindOption(), &Options::neighbors, &PointLinks::kind);
  return {.name = "branch_structure",
          .label = Shown::tr("Branch structure graph"),
          .help = Shown::tr(
              "Straightens the tree of shortest paths over all points, and merges what overlaps."),
          .inManual = Shown::tr("straightens such a tree, and merges what overlaps"),
          .source = "Y. Livny et al., ACM Trans. Graph. 29(6), 2010",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            reconstructKept(state, [&](const Eigen::Matrix3Xf& points, Eigen::Index root) {
              return skeletonByBranchStructure(points, root, table.with(values), progress);
            });
          }};
}

} // namespace espalier
