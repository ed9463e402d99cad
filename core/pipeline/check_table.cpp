#include "core/pipeline/check_table.h"

namespace espalier {
namespace {

OptionTable<CheckOptions> makeTable() {
  using Options = CheckOptions;
  OptionTable<Options> table;
  table.add(ratioOption("sensitivity", Shown::tr("Sensitivity"), 1.0 / 64, 64,
                        Shown::tr("At 2, all limits below are half as high: more is reported. It "
                                  "sets how near explained points are, too.")),
            &Options::sensitivity);
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
  table.add(ratioOption("detour", Shown::tr("Detour"), 1, 1000,
                        Shown::tr("Wood that touches is reported where the path from one to the "
                                  "other is longer than so many sums of their radii.")),
            &Options::detour);
  table.add(ratioOption("thicker", Shown::tr("Thicker than parent"), 0, 10,
                        Shown::tr("Nodes thicker than their parent by this share are reported.")),
            &Options::thicker);
  table.add(
      ratioOption("point_reach", Shown::tr("Reach of edges"), 0, 1000,
                  Shown::tr("Points farther from the wood, in point spacings, or more where these "
                            "scatter or the wood lies off them, are unexplained.")),
      &Options::pointReach);
  table.add(
      ratioOption("cluster_gap", Shown::tr("Cluster gap"), 0, 100,
                  Shown::tr("Unexplained points within so many point spacings are one cluster.")),
      &Options::clusterGap);
  table.add(countOption("cluster_size", Shown::tr("Cluster size"), 1, 1e6,
                        Shown::tr("Clusters of fewer points are strays of the scanner.")),
            &Options::clusterSize);
  table.add(ratioOption("cluster_rise", Shown::tr("Cluster stands out"), 0, 100,
                        Shown::tr("The farthest point of a small cluster is so many times as far "
                                  "off as the reach of edges.")),
            &Options::clusterRise);
  table.add(countOption("large_cluster", Shown::tr("Large cluster"), 1, 1e6,
                        Shown::tr("Clusters of so many points need not stand out.")),
            &Options::largeCluster);
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
  table.add(ratioOption("fewest_expected", Shown::tr("Points expected"), 0, 1e6,
                        Shown::tr("A stretch without points is reported if wood as thick has more "
                                  "points than this elsewhere.")),
            &Options::fewestExpected);
  table.add(angleOption("hidden_turn", Shown::tr("Turn of hidden wood"), 0, 180,
                        Shown::tr("Wood without points that goes on from wood with points and "
                                  "turns by less was hidden from the scanner.")),
            &Options::hiddenTurn);
  table.add(ratioOption("beside_units", Shown::tr("Beside its points"), 0, 1000,
                        Shown::tr("Wood that lies farther beside its points, in point spacings, or "
                                  "more where these scatter, is reported.")),
            &Options::besideUnits);
  table.add(ratioOption("beside_radii", Shown::tr("Beside its points, in radii"), 0, 100,
                        Shown::tr("Likewise, in radii of the wood; both must be exceeded.")),
            &Options::besideRadii);
  table.add(ratioOption("foot_spacings", Shown::tr("Short foot"), 0, 1000,
                        Shown::tr("Points of a stem that go on farther below its root, in point "
                                  "spacings, are reported.")),
            &Options::footSpacings);
  table.add(ratioOption("foot_radii", Shown::tr("Short foot, in radii"), 0, 100,
                        Shown::tr("Likewise, in radii of the stem; both must be exceeded.")),
            &Options::footRadii);
  return table;
}

} // namespace

const OptionTable<CheckOptions>& checkTable() {
  static const OptionTable<CheckOptions> table = makeTable();
  return table;
}

} // namespace espalier
