#include "core/pipeline/repair_methods.h"

#include "core/pipeline/method_parts.h"
#include "core/reconstruct/join_gaps.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/simplify_axes.h"
#include "core/skeleton/slide_insertions.h"
#include "core/skeleton/smooth_axes.h"

namespace espalier {
namespace {

Method joinMethod() {
  using Options = GapOptions;
  OptionTable<Options> table;
  table.add({.name = "widest",
             .label = "Longest edge",
             .kind = OptionKind::length,
             .rule = spacings(14),
             .minimum = 1,
             .maximum = 1000,
             .help = "Longer edges bridge a gap: what they lead to may be hung elsewhere."},
            &Options::widest);
  table.add({.name = "reach",
             .label = "Reach",
             .kind = OptionKind::length,
             .rule = spacings(40),
             .minimum = 1,
             .maximum = 10000,
             .help = "How far across a gap wood is looked for."},
            &Options::reach);
  table.add({.name = "turn_cost",
             .label = "Cost of turns",
             .kind = OptionKind::ratio,
             .rule = fixedAt(2),
             .minimum = 0,
             .maximum = 100,
             .help = "How much more a link costs that turns back than one straight on."},
            &Options::turnCost);
  table.add({.name = "side_cost",
             .label = "Cost of sides",
             .kind = OptionKind::ratio,
             .rule = fixedAt(1),
             .minimum = 0,
             .maximum = 100,
             .help = "How much more a link costs that ends at the side of wood, not at its tip."},
            &Options::sideCost);
  return {.name = "by_direction",
          .label = "Across gaps by direction",
          .help = "Hangs what lies beyond gaps on the wood that it goes on from, by direction, "
                  "radius and distance, for all at once.",
          .source = "choice: R. E. Tarjan, Networks 7, 1977",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            state.skeleton = withJoinedGaps(state.skeleton, table.with(values), progress);
          }};
}

Method insertionMethod() {
  using Options = InsertionOptions;
  OptionTable<Options> table;
  table.add({.name = "reach",
             .label = "Reach",
             .kind = OptionKind::count,
             .rule = fixedAt(3),
             .minimum = 1,
             .maximum = 50,
             .help = "Edges of the axis below, up and down from the branch, that are looked at."},
            &Options::reach);
  table.add({.name = "near_node",
             .label = "Near a node",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0.3),
             .minimum = 0,
             .maximum = 0.5,
             .help = "Share of an edge within which a branch goes to the node there, not to a new "
                     "one."},
            &Options::nearNode);
  return {.name = "slide",
          .label = "Slide along the axis",
          .help = "Hangs each branch where its first edges, drawn on backwards, meet the axis.",
          .source = {},
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            state.skeleton = withSlidInsertions(state.skeleton, table.with(values));
          }};
}

struct SpacingOptions {
  double length = 0;
};

Method evenMethod() {
  OptionTable<SpacingOptions> table;
  table.add({.name = "length",
             .label = "Length",
             .kind = OptionKind::length,
             .rule = spacings(6),
             .minimum = 0.1,
             .maximum = 1000,
             .help = "Wanted length of edges, between nodes that stay: branchings and ends."},
            &SpacingOptions::length);
  return {.name = "even",
          .label = "Even spacing",
          .help = "Spaces nodes evenly along each unbranched stretch.",
          .source = {},
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            SkeletonEditor editor(state.skeleton);
            resample(editor, state.skeleton.ids(), table.with(values).length);
            (void)editor.commit();
          }};
}

Method simpleMethod() {
  OptionTable<SpacingOptions> table;
  table.add(
      {.name = "tolerance",
       .label = "Tolerance",
       .kind = OptionKind::length,
       .rule = spacings(0.5),
       .minimum = 0,
       .maximum = 100,
       .help = "How far a node that is left out may lie from the line between its neighbors."},
      &SpacingOptions::length);
  return {.name = "by_curvature",
          .label = "By curvature",
          .help = "Leaves out nodes where axes are straight, so that there are many where they "
                  "bend.",
          .source = "D. Douglas, T. Peucker, Cartographica 10, 1973",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            state.skeleton = withSimpleAxes(state.skeleton, table.with(values).length);
          }};
}

struct SmoothingOptions {
  double share = 0;
  int rounds = 1;
};

Method smoothMethod() {
  OptionTable<SmoothingOptions> table;
  table.add({.name = "share",
             .label = "Share",
             .kind = OptionKind::ratio,
             .rule = fixedAt(0.5),
             .minimum = 0,
             .maximum = 1,
             .help = "Share of the way each node moves to the mean of its neighbors on the axis."},
            &SmoothingOptions::share);
  table.add({.name = "rounds",
             .label = "Rounds",
             .kind = OptionKind::count,
             .rule = fixedAt(2),
             .minimum = 1,
             .maximum = 100,
             .help = "How often."},
            &SmoothingOptions::rounds);
  return {.name = "smooth",
          .label = "Smooth",
          .help = "Smooths each axis; its ends stay.",
          .source = {},
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            const SmoothingOptions options = table.with(values);
            state.skeleton = withSmoothAxes(state.skeleton, options.share, options.rounds);
          }};
}

} // namespace

std::vector<Method> joinMethods() {
  return {noMethod("Keeps the shortest bridges."), joinMethod()};
}

std::vector<Method> insertionMethods() {
  // Sliding gains 0.003 of G, 0.005 of F and 0.012 of T on 20 grown plants, but loses up to 0.03 of
  // T on scans of experts' structures, where branches hang on the nodes that there were.
  return {noMethod("Leaves branches on the nodes they were found at."), insertionMethod()};
}

std::vector<Method> nodeMethods() {
  return {noMethod("Leaves the nodes as they are."), evenMethod(), simpleMethod(), smoothMethod()};
}

} // namespace espalier
