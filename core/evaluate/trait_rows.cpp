#include "core/evaluate/trait_rows.h"

#include "core/base/shown_message.h"

#include <utility>

namespace espalier {
namespace {

/// Adds rows to one group after the other.
class Rows {
public:
  void begin(const std::string& group) { group_ = group; }
  void add(TraitKind kind, const std::string& label, double value, const std::string& help) {
    rows_.push_back({group_, label, help, kind, value});
  }
  void add(const std::string& label, std::size_t count, const std::string& help) {
    add(TraitKind::count, label, static_cast<double>(count), help);
  }
  [[nodiscard]] std::vector<TraitRow> take() && { return std::move(rows_); }

private:
  std::string group_;
  std::vector<TraitRow> rows_;
};

void addSizes(Rows& rows, const Traits& traits) {
  rows.begin(Shown::tr("Size"));
  rows.add(Shown::tr("nodes"), traits.nodes, Shown::tr("Nodes of the skeleton"));
  rows.add(Shown::tr("trees"), traits.roots, Shown::tr("Roots: parts that are not connected"));
  rows.add(Shown::tr("segments"), traits.segments,
           Shown::tr("Stretches between branchings, roots and tips"));
  rows.add(Shown::tr("tips"), traits.tips, Shown::tr("Nodes without a child"));
  rows.add(Shown::tr("branchings"), traits.branchings, Shown::tr("Nodes with several children"));
  rows.add(Shown::tr("orders"), traits.axesByOrder.size(),
           Shown::tr("How many orders of axes there are, the trunk included"));
  rows.add(
      Shown::tr("Strahler number"), traits.strahler.size(),
      Shown::tr("A tip has 1; a node the greatest above it, and one more where several have that"));
  rows.add(TraitKind::length, Shown::tr("length"), traits.length, Shown::tr("Of all edges"));
  rows.add(TraitKind::length, Shown::tr("median edge"), traits.medianEdge,
           Shown::tr("Between a node and its parent"));
}

void addStem(Rows& rows, const StemTraits& stem) {
  constexpr auto length = TraitKind::length;
  rows.begin(Shown::tr("Stem"));
  rows.add(length, Shown::tr("stem length"), stem.length,
           Shown::tr("Along the axis that begins at the root"));
  rows.add(length, Shown::tr("lowest branch on it"), stem.lowestBranch,
           Shown::tr("Along the stem"));
  rows.add(length, Shown::tr("highest branch on it"), stem.highestBranch,
           Shown::tr("Along the stem"));
  rows.add(length, Shown::tr("stem radius at the base"), stem.baseRadius,
           Shown::tr("Of its first node with a radius"));
  rows.add(length, Shown::tr("stem radius at the top"), stem.topRadius,
           Shown::tr("Of its last node"));
}

void addCrown(Rows& rows, const CrownDimensions& crown) {
  constexpr auto length = TraitKind::length;
  rows.begin(Shown::tr("Crown"));
  rows.add(length, Shown::tr("height"), crown.height,
           Shown::tr("From the lowest node to the highest"));
  rows.add(length, Shown::tr("crown base"), crown.baseHeight,
           Shown::tr("Height above the lowest node of where the lowest branch leaves"));
  rows.add(length, Shown::tr("crown depth"), crown.depth,
           Shown::tr("From there to the highest node"));
  rows.add(TraitKind::area, Shown::tr("crown area"), crown.area,
           Shown::tr("Of the convex hull of the branches, seen from above"));
  rows.add(length, Shown::tr("crown diameter"), crown.diameter,
           Shown::tr("Of a circle of that area"));
  rows.add(length, Shown::tr("crown spread"), crown.spread,
           Shown::tr("Greatest horizontal distance between two nodes of branches"));
}

void addAngles(Rows& rows, const BranchAngles& angles) {
  rows.begin(Shown::tr("Angles by order"));
  for (std::size_t k = 0; k < angles.byOrder.size(); ++k)
    rows.add(TraitKind::angle,
             inEnglish({Shown::tr("branching angle, order %1"), {std::to_string(k + 1)}}),
             angles.byOrder[k].mean,
             Shown::tr("Mean, between branches of this order and what bears them"));
  rows.begin(Shown::tr("Branching"));
  if (angles.divergence.count > 0)
    rows.add(TraitKind::angle, Shown::tr("divergence"), angles.divergence.mean,
             Shown::tr("Mean, around the axis from one branch to the next"));
}

void addTraits(Rows& rows, const Traits& traits) {
  addSizes(rows, traits);
  addStem(rows, traits.stem);
  addCrown(rows, traits.crown);
  addAngles(rows, traits.angles);
}

} // namespace

std::vector<TraitRow> traitRows(const Traits& traits) {
  Rows rows;
  addTraits(rows, traits);
  return std::move(rows).take();
}

std::vector<TraitRow> traitRows(const PlantMeasures& measures) {
  Rows rows;
  addTraits(rows, measures.traits);
  rows.begin(Shown::tr("Wood"));
  rows.add(TraitKind::volume, Shown::tr("volume"), measures.wood.whole.volume,
           measures.volumeUnknown > mostUnknownError
               ? Shown::tr("Edges count as truncated cones. It has no bounds: how radii err is "
                           "known of those that a reconstruction found or a hand typed, which "
                           "here are under nine tenths of the volume")
               : Shown::tr("Edges count as truncated cones"));
  if (measures.volume) {
    rows.add(
        TraitKind::volume, Shown::tr("volume, at least"), measures.volume->least,
        Shown::tr(
            "With a probability of 95 %, as far as the radii err; missing wood does not count"));
    rows.add(
        TraitKind::volume, Shown::tr("volume, at most"), measures.volume->most,
        Shown::tr(
            "With a probability of 95 %, as far as the radii err; missing wood does not count"));
  }
  rows.add(TraitKind::area, Shown::tr("bark area"), measures.wood.whole.area,
           Shown::tr("Of the same"));
  if (measures.stemDiameter)
    rows.add(TraitKind::length, Shown::tr("diameter at 1.3 m"), *measures.stemDiameter,
             Shown::tr("Of the stem, at breast height above the foot"));
  if (measures.light) {
    rows.begin(Shown::tr("Light"));
    rows.add(TraitKind::share, Shown::tr("STAR"), measures.light->star,
             Shown::tr("Silhouette to total area, over an overcast sky; 0.25 of a sphere"));
    rows.add(TraitKind::area, Shown::tr("surface"), measures.light->area,
             Shown::tr("Of the wood that light falls on"));
  }
  return std::move(rows).take();
}

} // namespace espalier
