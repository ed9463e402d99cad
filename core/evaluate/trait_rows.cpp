#include "core/evaluate/trait_rows.h"

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
  rows.begin("Size");
  rows.add("nodes", traits.nodes, "Nodes of the skeleton");
  rows.add("trees", traits.roots, "Roots: parts that are not connected");
  rows.add("segments", traits.segments, "Stretches between branchings, roots and tips");
  rows.add("tips", traits.tips, "Nodes without a child");
  rows.add("branchings", traits.branchings, "Nodes with several children");
  rows.add("orders", traits.axesByOrder.size(),
           "How many orders of axes there are, the trunk included");
  rows.add("Strahler number", traits.strahler.size(),
           "A tip has 1; a node the greatest above it, and one more where several have that");
  rows.add(TraitKind::length, "length", traits.length, "Of all edges");
  rows.add(TraitKind::length, "median edge", traits.medianEdge, "Between a node and its parent");
}

void addStem(Rows& rows, const StemTraits& stem) {
  constexpr auto length = TraitKind::length;
  rows.begin("Stem");
  rows.add(length, "stem length", stem.length, "Along the axis that begins at the root");
  rows.add(length, "lowest branch on it", stem.lowestBranch, "Along the stem");
  rows.add(length, "highest branch on it", stem.highestBranch, "Along the stem");
  rows.add(length, "stem radius at the base", stem.baseRadius, "Of its first node with a radius");
  rows.add(length, "stem radius at the top", stem.topRadius, "Of its last node");
}

void addCrown(Rows& rows, const CrownDimensions& crown) {
  constexpr auto length = TraitKind::length;
  rows.begin("Crown");
  rows.add(length, "height", crown.height, "From the lowest node to the highest");
  rows.add(length, "crown base", crown.baseHeight,
           "Height above the lowest node of where the lowest branch leaves");
  rows.add(length, "crown depth", crown.depth, "From there to the highest node");
  rows.add(TraitKind::area, "crown area", crown.area,
           "Of the convex hull of the branches, seen from above");
  rows.add(length, "crown diameter", crown.diameter, "Of a circle of that area");
  rows.add(length, "crown spread", crown.spread,
           "Greatest horizontal distance between two nodes of branches");
}

void addAngles(Rows& rows, const BranchAngles& angles) {
  rows.begin("Angles by order");
  for (std::size_t k = 0; k < angles.byOrder.size(); ++k)
    rows.add(TraitKind::angle, "branching angle, order " + std::to_string(k + 1),
             angles.byOrder[k].mean, "Mean, between branches of this order and what bears them");
  rows.begin("Branching");
  if (angles.divergence.count > 0)
    rows.add(TraitKind::angle, "divergence", angles.divergence.mean,
             "Mean, around the axis from one branch to the next");
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
  rows.begin("Wood");
  rows.add(TraitKind::volume, "volume", measures.wood.whole.volume,
           "Edges count as truncated cones");
  if (measures.volume) {
    rows.add(TraitKind::volume, "volume, at least", measures.volume->least,
             "With a probability of 95 %, as far as the radii err; missing wood does not count");
    rows.add(TraitKind::volume, "volume, at most", measures.volume->most,
             "With a probability of 95 %, as far as the radii err; missing wood does not count");
  }
  rows.add(TraitKind::area, "bark area", measures.wood.whole.area, "Of the same");
  if (measures.stemDiameter)
    rows.add(TraitKind::length, "diameter at 1.3 m", *measures.stemDiameter,
             "Of the stem, at breast height above the foot");
  if (measures.light) {
    rows.begin("Light");
    rows.add(TraitKind::share, "STAR", measures.light->star,
             "Silhouette to total area, over an overcast sky; 0.25 of a sphere");
    rows.add(TraitKind::area, "surface", measures.light->area, "Of the wood that light falls on");
  }
  return std::move(rows).take();
}

} // namespace espalier
