#include "core/decide/decide_gaps.h"
#include "core/graph/turn_upright.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/methods.h"
#include "core/reconstruct/join_gaps.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/simplify_axes.h"
#include "core/skeleton/slide_insertions.h"
#include "core/skeleton/smooth_axes.h"

namespace espalier {
namespace {

Option widestEdgeOption() {
  return lengthOption(
      "widest", Shown::tr("Longest edge"), 1, 1000,
      Shown::tr("Edges longer than this, and than the wood at their ends is thick, bridge a gap: "
                "what they lead to may be attached elsewhere."));
}

Option gapReachOption() {
  return lengthOption("reach", Shown::tr("Reach"), 1, 10000,
                      Shown::tr("How far across a gap wood is looked for."));
}

Method joinByOddsMethod() {
  using Options = GapOptions;
  OptionTable<Options> table;
  table.add(widestEdgeOption(), &Options::widest);
  table.add(gapReachOption(), &Options::reach);
  return {.name = "by_odds",
          .label = Shown::tr("Across gaps by odds"),
          .help = Shown::tr(
              "Attaches what lies beyond gaps by the links that are together the most probable."),
          .source = "odds: D. McFadden, Frontiers in Econometrics, 1974; choice: R. E. Tarjan, "
                    "Networks 7, 1977",
          .options = table.descriptions(),
          .seesUp = true,
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            const Eigen::Vector3d up = turnUpright(state.up).row(2).transpose();
            GapOptions options = table.with(values);
            options.backCost = Length(options.backCost.rule().value(state.extent.scale));
            DecidedGaps decided =
                withDecidedGaps(*state.skeleton, state.extent.scale.spacing, up, options, progress);
            state.setSkeleton(std::move(decided.skeleton));
            state.gaps =
                std::make_shared<const std::vector<GapDecision>>(std::move(decided.decisions));
          }};
}

Method joinByDirectionMethod() {
  using Options = GapOptions;
  OptionTable<Options> table({.widest = spacings(5)}); // its costs err more on short gaps
  table.add(widestEdgeOption(), &Options::widest);
  table.add(gapReachOption(), &Options::reach);
  table.add(
      ratioOption("turn_cost", Shown::tr("Cost of turns"), 0, 100,
                  Shown::tr("How much more a link costs that turns back than one straight on.")),
      &Options::turnCost);
  table.add(
      lengthOption(
          "back_cost", Shown::tr("Cost of branches that point back"), 0, 10000,
          Shown::tr("What each branch costs that would point back to where its wood begins.")),
      &Options::backCost);
  return {.name = "by_direction",
          .label = Shown::tr("Across gaps by direction"),
          .help = Shown::tr(
              "Attaches what lies beyond gaps to the wood that it goes on from, by direction, "
              "radius and distance, for all at once."),
          .source = "choice: R. E. Tarjan, Networks 7, 1977",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            state.setSkeleton(withJoinedGaps(*state.skeleton, table.with(values), progress));
          }};
}

Method insertionMethod() {
  using Options = InsertionOptions;
  OptionTable<Options> table;
  table.add(
      countOption(
          "reach", Shown::tr("Reach"), 1, 50,
          Shown::tr("Edges of the axis below, up and down from the branch, that are looked at.")),
      &Options::reach);
  table.add(
      ratioOption(
          "near_node", Shown::tr("Near a node"), 0, 0.5,
          Shown::tr("Share of an edge within which a branch goes to the node there, not to a new "
                    "one.")),
      &Options::nearNode);
  table.add(
      ratioOption(
          "node_weight", Shown::tr("Weight of the node"), 0, 100,
          Shown::tr("How much the node counts that a branch was found on; its line counts 1 where "
                    "it meets the axis at a right angle, less where it is flatter.")),
      &Options::nodeWeight);
  table.add(
      lengthOption(
          "gather", Shown::tr("Gather"), 0, 100,
          Shown::tr("Branches that leave the axis nearer to each other than this leave it at one "
                    "place.")),
      &Options::gather);
  return {.name = "slide",
          .label = Shown::tr("Slide along the axis"),
          .help = Shown::tr(
              "Attaches each branch nearer to where its first edges, drawn on backwards, meet the "
              "axis."),
          .source = {},
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            state.setSkeleton(withSlidInsertions(*state.skeleton, table.with(values)));
          }};
}

struct EvenOptions {
  Length length = spacings(6);
};

Method evenMethod() {
  OptionTable<EvenOptions> table;
  table.add(lengthOption(
                "length", Shown::tr("Length"), 0.1, 1000,
                Shown::tr("Wanted length of edges, between nodes that stay: branchings and ends.")),
            &EvenOptions::length);
  return {.name = "even",
          .label = Shown::tr("Even spacing"),
          .help = Shown::tr("Spaces nodes evenly along each unbranched stretch."),
          .source = {},
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            Skeleton skeleton = *state.skeleton;
            SkeletonEditor editor(skeleton);
            resample(editor, skeleton.ids(), table.with(values).length);
            (void)editor.commit();
            state.setSkeleton(std::move(skeleton));
          }};
}

struct CurvatureOptions {
  Length tolerance = spacings(0.5);
};

Method simpleMethod() {
  OptionTable<CurvatureOptions> table;
  table.add(
      lengthOption(
          "tolerance", Shown::tr("Tolerance"), 0, 100,
          Shown::tr(
              "How far a node that is left out may lie from the line between its neighbors.")),
      &CurvatureOptions::tolerance);
  return {.name = "by_curvature",
          .label = Shown::tr("By curvature"),
          .help = Shown::tr(
              "Leaves out nodes where axes are straight, so that there are many where they "
              "bend."),
          .source = "D. Douglas, T. Peucker, Cartographica 10, 1973",
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            state.setSkeleton(withSimpleAxes(*state.skeleton, table.with(values).tolerance));
          }};
}

struct SmoothingOptions {
  double share = 0.5;
  int rounds = 2;
};

Method smoothMethod() {
  OptionTable<SmoothingOptions> table;
  table.add(
      ratioOption("share", Shown::tr("Share"), 0, 1,
                  Shown::tr("How far each node moves to the mean of its neighbors on the axis.")),
      &SmoothingOptions::share);
  table.add(countOption("rounds", Shown::tr("Rounds"), 1, 100, Shown::tr("How often.")),
            &SmoothingOptions::rounds);
  return {.name = "smooth",
          .label = Shown::tr("Smooth"),
          .help = Shown::tr("Smooths each axis; its ends stay."),
          .source = {},
          .options = table.descriptions(),
          .run = [table](PipelineState& state, const Values& values, const Progress& progress) {
            progress.check();
            const SmoothingOptions options = table.with(values);
            state.setSkeleton(withSmoothAxes(*state.skeleton, options.share, options.rounds));
          }};
}

} // namespace

std::vector<Method> joinMethods() {
  // By odds, on 30 simulated plants of under 60 points a segment that they were not fitted on, T is
  // 0.710 where by direction it is 0.697, F within 2.5 spacings 0.901 and 0.893. Gaps from 5
  // spacings on: 0.695, 0.898; by direction gaps from 3 on: 0.671, 0.890. With one link of each two
  // pieces, the cheapest, and less evidence, T was 0.696, F 0.895, and of 35 denser plants 0.881,
  // 0.913 for 0.890, 0.916 now. Fitted on gaps from 3 spacings on, most of which are easy, T is
  // 0.698; without links that are nearly alike 0.708.
  //
  // By direction, T of 24 grown plants and 9 scans of structures, each bare and leafy: 0.853,
  // 0.811, 0.899, 0.849 by the shortest bridges; 0.861, 0.827, 0.900, 0.852 by direction, with F
  // 0.004 more on leafy grown plants; A3B4 0.912 and 0.919, puu1 0.844 and 0.842. With long edges
  // cut whether they lie within thick wood or not, as it once was, T of structures fell by 0.03 and
  // that of puu1 by 0.08; without the cost of branches that point back, grown plants gain less by
  // 0.005. Were every gap bridged right, T would be 0.889 of bare grown plants and 0.903 of
  // structures: they are 60 spacings wide, and most of what is beyond them is nearer to something
  // else.
  //
  // From 8 spacings on instead of 10, grown plants gain 0.004 more, but puu1 loses 0.007; a reach
  // of 70 loses 0.03 of leafy structures, where one large crown is wrongly attached. A cost of
  // links to the sides of wood gains nothing. Nor does it to attach branches anew that leave a node
  // straight across it from one another, as where twigs touch (T of bare grown plants 0.862 as
  // without, of structures 0.882 to 0.888 instead of 0.892), or that point back from the axis
  // (0.851 to 0.858, and 0.891 to 0.893). Nor, after Prune and with radii, to attach each branch to
  // the place that it grows from with 0.65 or more by the odds that doubts have: T rises by 0.005
  // on 28 plants (any --first 1301 --seeds 2) and falls by 0.001 on 70 (--first 3101 --seeds 5),
  // and a run takes a fifth longer.
  return {joinByOddsMethod(), joinByDirectionMethod(),
          noMethod(Shown::tr("Keeps the shortest bridges."))};
}

std::vector<Method> insertionMethods() {
  // Without it, branches are attached a median 3.0 spacings too far up grown plants (2.4 beyond 60
  // degrees, 3.8 at 30 to 45) and 1.4 up structures; slid all the way (node_weight 0), 0.2 too far
  // up grown ones, but 1.0 too far down structures, whose middle half then spreads over 4.9
  // spacings instead of 2.7: their branches bend near the foot. T of 32 grown plants and 9 scans of
  // structures, each bare and leafy: 0.846, 0.811, 0.884, 0.823 without; 0.861, 0.824, 0.901, 0.847
  // all the way; 0.861, 0.829, 0.904, 0.856 with node_weight 0.3; 0.856, 0.820, 0.899, 0.850
  // with 1.
  //
  // Those who made structures of real scans by hand attached branches where their points part: the
  // default without it is a median 0.0 spacings (A3B4) and -0.5 (puu1) off them, all the way -2.7
  // and -2.9. T of the two, 0.900 and 0.843 without, is 0.847 and 0.798 all the way, 0.912 and
  // 0.832 with 0.3, 0.912 and 0.844 with 1: so 1, of which none loses.
  //
  // Not taken, as they gain no more: the direction of the first or first two edges instead of three
  // (T as above 0.856, 0.820, 0.899, 0.846 with the first), one that follows the bend of the branch
  // (0.853, 0.821, 0.895, 0.845), and branches slid by no more than 2 to 4 spacings.
  // Gathered in 6 spacings instead of 4, structures gain T 0.008 and lose G 0.002, and A3B4 loses
  // T 0.020.
  return {insertionMethod(),
          noMethod(Shown::tr("Leaves branches on the nodes they were found at."))};
}

std::vector<Method> nodeMethods() {
  return {noMethod(Shown::tr("Leaves the nodes as they are.")), evenMethod(), simpleMethod(),
          smoothMethod()};
}

} // namespace espalier
