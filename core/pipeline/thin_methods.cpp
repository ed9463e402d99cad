#include "core/clean/thinning.h"
#include "core/pipeline/clean_parts.h"
#include "core/pipeline/methods.h"

namespace espalier {
namespace {

Option seedOption() {
  return countOption("seed", Shown::tr("Seed"), 1, 1000000,
                     Shown::tr("Another seed draws other points."));
}

/// @param thinned (points, options, progress): which of them are left out
template <class Options, class Thinned>
Method thinMethod(const char* name, const char* label, const char* help, const char* source,
                  const OptionTable<Options>& table, const Thinned& thinned) {
  return {.name = name,
          .label = label,
          .help = help,
          .source = source,
          .options = table.descriptions(),
          .seesRoot = false,
          .changesScale = true,
          .run = [table, thinned](PipelineState& state, const Values& values,
                                  const Progress& progress) {
            leaveOutFarPoints(state);
            const std::vector<Eigen::Index> kept = keptPoints(state);
            leaveOut(
                state, kept,
                thinned(state.cloud->positions()(Eigen::all, kept), table.with(values), progress));
          }};
}

Method chanceMethod() {
  using Options = RandomThinningOptions;
  OptionTable<Options> table;
  table.add(ratioOption("share", Shown::tr("Share"), 0.0001, 1,
                        Shown::tr("How many of the points stay.")),
            &Options::share);
  table.add(seedOption(), &Options::seed);
  return thinMethod("random", Shown::tr("By chance"),
                    Shown::tr("Keeps a share of the points, drawn by chance."), "", table,
                    thinnedByChance);
}

Method cubeMethod() {
  using Options = VoxelThinningOptions;
  OptionTable<Options> table;
  table.add(lengthOption("edge", Shown::tr("Edge"), 0.1, 1e5,
                         Shown::tr("Of the cubes, of each of which one point stays.")),
            &Options::edge);
  return thinMethod("voxels", Shown::tr("One per cube"),
                    Shown::tr("Keeps one point of each cube of an even grid: the one nearest to "
                              "their mean."),
                    "", table, thinnedByVoxels);
}

Method spacingMethod() {
  using Options = SpacingThinningOptions;
  OptionTable<Options> table;
  table.add(lengthOption("spacing", Shown::tr("Spacing"), 0.1, 1e5,
                         Shown::tr("No two points that stay are nearer to each other than this.")),
            &Options::spacing);
  table.add(seedOption(), &Options::seed);
  return thinMethod("spacing", Shown::tr("Least spacing"),
                    Shown::tr("Keeps points that are not too near to each other, as evenly as they "
                              "lie."),
                    "R. L. Cook, ACM Trans. Graph. 5(1), 1986", table, thinnedBySpacing);
}

} // namespace

std::vector<Method> thinMethods() {
  return {noMethod(Shown::tr("Keeps as many points as there are.")), chanceMethod(), cubeMethod(),
          spacingMethod()};
}

} // namespace espalier
