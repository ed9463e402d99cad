#include "core/io/dropped.h"

#include <cassert>

namespace espalier {
namespace {

/// What there is in a skeleton to be kept.
struct Contents {
  bool radii = false;
  bool edgeTypes = false; // some branch, or a node has several children
  bool severalTrees = false;
  bool entities = false;
  bool labels = false;
  bool features = false;
  bool dates = false;
  bool review = false; // marks or comments
  bool unitStarts = false;
};

/// Whether an entity only says what a skeleton says without it: that there are plants of nodes, as
/// PlantScan3D's MTGs do. `plain` is the class of the nodes.
bool isPlain(const Entity& entity, const Node& node, const std::string& plain) {
  const bool isOwn = &entity == &node.entities.back();
  return isOwn ? entity.symbol == plain && !entity.index : !node.parent;
}

void add(const Entity& entity, bool isPlain, Contents& contents) {
  contents.entities = contents.entities || !isPlain;
  contents.labels = contents.labels || (!isPlain && entity.index) || !entity.alias.empty();
  contents.features = contents.features || !entity.values.empty();
  contents.dates = contents.dates || !entity.later.empty();
}

Contents contentsOf(const Skeleton& skeleton) {
  Contents contents;
  std::size_t roots = 0;
  std::string plain;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    if (node.radius > 0) contents.radii = true;
    if (node.review != ReviewMark()) contents.review = true;
    if (node.isMarked) contents.unitStarts = true;
    if (!node.parent) ++roots;
    const bool branches = node.parent && node.edge == EdgeType::branching;
    if (branches || skeleton.children(id).size() > 1) contents.edgeTypes = true;
    if (plain.empty() && !node.entities.empty()) plain = node.entities.back().symbol;
    for (const Entity& entity : node.entities)
      add(entity, isPlain(entity, node, plain), contents);
  }
  contents.severalTrees = roots > 1;
  return contents;
}

/// Of the formats that can write it at all.
Contents contentsOf(const Mtg& mtg) {
  Contents contents{.entities = true};
  for (const MtgVertex& vertex : mtg.vertices) {
    contents.labels = contents.labels || vertex.index || !vertex.alias.empty();
    contents.features = contents.features || !vertex.values.empty();
    contents.dates = contents.dates || !vertex.later.empty();
  }
  return contents;
}

std::vector<ShownMessage> droppedBy(const Format& format, const Contents& contents) {
  std::vector<ShownMessage> sentences;
  const auto check = [&](bool isThere, bool isCarried, const char* sentence) {
    if (isThere && !isCarried) sentences.push_back({sentence, {std::string(format.name)}});
  };
  const Carried& carried = format.carried;
  check(contents.radii, carried.radii,
        Shown::tr("%1 keeps no radii: how thick the nodes are is not written"));
  check(contents.edgeTypes, carried.edgeTypes,
        Shown::tr("%1 keeps no edge types: which child continues an axis is not written"));
  check(contents.severalTrees, carried.severalTrees,
        Shown::tr("%1 keeps one tree only: the others are not written"));
  check(contents.entities, carried.entities,
        Shown::tr("%1 keeps no classes or scales: units and axes that the nodes belong to are not "
                  "written"));
  check(contents.labels, carried.labels,
        Shown::tr("%1 keeps no labels: indices and aliases are not written"));
  check(contents.features, carried.features,
        Shown::tr("%1 keeps no features: values beside position and radius are not written"));
  check(contents.dates, carried.dates,
        Shown::tr("%1 keeps one date only: values at later dates are not written"));
  check(contents.review, false,
        Shown::tr("%1 keeps no review: marks, comments and signatures are not written; only a "
                  "project keeps them"));
  check(contents.unitStarts, false,
        Shown::tr("%1 keeps no marks of unit starts: they are not written; only a project keeps "
                  "them"));
  return sentences;
}

} // namespace

std::vector<ShownMessage> droppedBy(const Format& format, const Skeleton& skeleton) {
  assert(format.content == Content::structure);
  return droppedBy(format, contentsOf(skeleton));
}

std::vector<ShownMessage> droppedBy(const Format& format, const Structure& structure) {
  if (!isWithoutPositions(structure)) return droppedBy(format, structure.skeleton);
  return droppedBy(format, contentsOf(structure.frame->mtg));
}

} // namespace espalier
