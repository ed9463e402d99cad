#include "core/pipeline/check_table.h"

namespace espalier {
namespace {

OptionTable<CheckOptions> makeTable() {
  using Options = CheckOptions;
  OptionTable<Options> table;
  table.add(angleOption("sharp_turn", Shown::tr("Sharp turn"), 10, 180,
                        Shown::tr("An axis that turns by more at a node is reported.")),
            &Options::sharpTurn);
  table.add(angleOption("branch_turn", Shown::tr("Branch turning back"), 10, 180,
                        Shown::tr("A branch that turns by more from what bears it, or from its "
                                  "first edge, is reported.")),
            &Options::branchTurn);
  table.add(
      ratioOption("short_edge", Shown::tr("Short edge"), 0, 0.1,
                  Shown::tr("Edges shorter than this share of the mean edge have no length.")),
      &Options::shortEdge);
  table.add(
      ratioOption(
          "duplicate_share", Shown::tr("Duplicate"), 0, 0.5,
          Shown::tr("Edges whose ends lie within this share of their length are duplicates.")),
      &Options::duplicateShare);
  table.add(
      ratioOption(
          "touch", Shown::tr("Touch"), 0, 20,
          Shown::tr("Center lines within so many point spacings touch, however thin the wood.")),
      &Options::touch);
  table.add(ratioOption(
                "detour", Shown::tr("Detour"), 1, 1000,
                Shown::tr("Wood may touch that is within so many sums of radii along the plant.")),
            &Options::detour);
  table.add(
      ratioOption("point_reach", Shown::tr("Reach of edges"), 0, 1000,
                  Shown::tr("Points farther from the wood, in point spacings, are unexplained.")),
      &Options::pointReach);
  table.add(
      ratioOption("cluster_gap", Shown::tr("Cluster gap"), 0, 100,
                  Shown::tr("Unexplained points within so many point spacings are one cluster.")),
      &Options::clusterGap);
  table.add(countOption("cluster_size", Shown::tr("Cluster size"), 1, 1e6,
                        Shown::tr("Clusters of fewer points are strays of the scanner.")),
            &Options::clusterSize);
  table.add(ratioOption("empty_reach", Shown::tr("Reach of points"), 0, 1000,
                        Shown::tr("Edges with no points within so many point spacings, along over "
                                  "a half, are reported.")),
            &Options::emptyReach);
  table.add(
      ratioOption(
          "own_beside", Shown::tr("Reach of other wood"), 0, 1000,
          Shown::tr("Points within so many point spacings of other wood are not a branch's own.")),
      &Options::ownBeside);
  table.add(
      ratioOption("own_reach", Shown::tr("Reach of own points"), 0, 1000,
                  Shown::tr("Own points of a branch lie within so many point spacings of it.")),
      &Options::ownReach);
  table.add(countOption("own_count", Shown::tr("Own points"), 1, 1e6,
                        Shown::tr("Fewer own points at a place of a branch are strays.")),
            &Options::ownCount);
  table.add(
      ratioOption(
          "own_length", Shown::tr("Length without own points"), 0, 1000,
          Shown::tr(
              "Branches that begin with more point spacings without own points are reported.")),
      &Options::ownLength);
  return table;
}

} // namespace

const OptionTable<CheckOptions>& checkTable() {
  static const OptionTable<CheckOptions> table = makeTable();
  return table;
}

} // namespace espalier
