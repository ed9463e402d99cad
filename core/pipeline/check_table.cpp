#include "core/pipeline/check_table.h"

#include <numbers>

namespace espalier {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

OptionTable<CheckOptions> makeTable() {
  const CheckOptions defaults;
  OptionTable<CheckOptions> table;
  const auto add = [&](const char* name, const char* label, OptionKind kind, double value,
                       double minimum, double maximum, const char* help, auto member) {
    table.add({.name = name,
               .label = label,
               .kind = kind,
               .rule = fixedAt(value),
               .minimum = minimum,
               .maximum = maximum,
               .help = help},
              member);
  };
  add("sharp_turn", "Sharp turn", OptionKind::angle, defaults.sharpTurn * degrees, 10, 180,
      "An axis that turns by more at a node is reported.", &CheckOptions::sharpTurn);
  add("branch_turn", "Branch turning back", OptionKind::angle, defaults.branchTurn * degrees, 10,
      180, "A branch that turns by more from what bears it, or from its first edge, is reported.",
      &CheckOptions::branchTurn);
  add("short_edge", "Short edge", OptionKind::ratio, defaults.shortEdge, 0, 0.1,
      "Edges shorter than this share of the mean edge have no length.", &CheckOptions::shortEdge);
  add("duplicate_share", "Duplicate", OptionKind::ratio, defaults.duplicateShare, 0, 0.5,
      "Edges whose ends lie within this share of their length are duplicates.",
      &CheckOptions::duplicateShare);
  add("touch", "Touch", OptionKind::ratio, defaults.touch, 0, 20,
      "Center lines within so many point spacings touch, however thin the wood.",
      &CheckOptions::touch);
  add("detour", "Detour", OptionKind::ratio, defaults.detour, 1, 1000,
      "Wood may touch that is within so many sums of radii along the plant.",
      &CheckOptions::detour);
  add("point_reach", "Reach of edges", OptionKind::ratio, defaults.pointReach, 0, 1000,
      "Points farther from the wood, in point spacings, are unexplained.",
      &CheckOptions::pointReach);
  add("cluster_gap", "Cluster gap", OptionKind::ratio, defaults.clusterGap, 0, 100,
      "Unexplained points within so many point spacings are one cluster.",
      &CheckOptions::clusterGap);
  add("cluster_size", "Cluster size", OptionKind::count, defaults.clusterSize, 1, 1e6,
      "Clusters of fewer points are strays of the scanner.", &CheckOptions::clusterSize);
  add("empty_reach", "Reach of points", OptionKind::ratio, defaults.emptyReach, 0, 1000,
      "Edges with no points within so many point spacings, along over a half, are reported.",
      &CheckOptions::emptyReach);
  add("own_beside", "Reach of other wood", OptionKind::ratio, defaults.ownBeside, 0, 1000,
      "Points within so many point spacings of other wood are not a branch's own.",
      &CheckOptions::ownBeside);
  add("own_reach", "Reach of own points", OptionKind::ratio, defaults.ownReach, 0, 1000,
      "Own points of a branch lie within so many point spacings of it.", &CheckOptions::ownReach);
  add("own_count", "Own points", OptionKind::count, defaults.ownCount, 1, 1e6,
      "Fewer own points at a place of a branch are strays.", &CheckOptions::ownCount);
  add("own_length", "Length without own points", OptionKind::ratio, defaults.ownLength, 0, 1000,
      "Branches that begin with more point spacings without own points are reported.",
      &CheckOptions::ownLength);
  return table;
}

} // namespace

const OptionTable<CheckOptions>& checkTable() {
  static const OptionTable<CheckOptions> table = makeTable();
  return table;
}

} // namespace espalier
