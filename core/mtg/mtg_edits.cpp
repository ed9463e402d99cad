#include "core/mtg/mtg_edits.h"

#include "core/base/shown_message.h"
#include "core/mtg/mtg_root_units.h"
#include "core/mtg/mtg_rules.h"
#include "core/mtg/mtg_scale_shift.h"
#include "core/mtg/mtg_unit_claims.h"
#include "core/mtg/mtg_units.h"
#include "core/mtg/mtg_vertex_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_set>
#include <utility>

namespace espalier {
namespace {

void requireFinite(const Skeleton& skeleton) {
  for (const NodeId id : skeleton.ids())
    if (!skeleton[id].position.allFinite() || !std::isfinite(skeleton[id].radius))
      throw ShownError({espalier::Shown::tr("node %1 has a position or radius that is not finite: "
                                            "correct it before saving"),
                        {std::to_string(indexOf(id))}});
}

std::vector<int> scalesOf(const MtgView& view, const Skeleton& edited) {
  std::vector<int> scales = unitScales(view.skeleton, view.scale);
  const std::vector<int> more = unitScales(edited, view.scale);
  scales.insert(scales.end(), more.begin(), more.end());
  std::ranges::sort(scales);
  scales.erase(std::unique(scales.begin(), scales.end()), scales.end());
  return scales;
}

using MaybeVertex = std::optional<VertexId>;

/// The vertices of the base, then the new ones, being joined anew; assembled at last.
class Edit {
public:
  Edit(const Mtg& base, const MtgView& view, const Skeleton& edited)
      : base_(base), view_(view), roots_(withRootUnits(view, edited)), edited_(roots_.skeleton),
        scales_(scalesOf(view, edited_)), before_(view.skeleton, scales_, view.scale),
        after_(edited_, scales_, view.scale), mtg_(base) {
    claimUnits();
    placeNodes();
    dropVertices();
    joinUnits();
    joinNodes();
    joinOthers();
    numberNewVertices();
    writeNodes();
  }

  [[nodiscard]] Mtg result();

private:
  [[nodiscard]] MtgVertex& vertex(VertexId id) { return mtg_.vertices[indexOf(id)]; }
  [[nodiscard]] bool isNew(VertexId id) const { return indexOf(id) >= base_.vertices.size(); }
  [[nodiscard]] bool wasNode(NodeId id) const { return view_.skeleton.contains(id); }
  [[nodiscard]] bool isGone(VertexId id) const { return !isNew(id) && gone_[indexOf(id)] != 0; }
  VertexId addVertex(const Entity& entity);
  [[nodiscard]] MaybeVertex unitBefore(std::optional<std::size_t> unit) const;
  [[nodiscard]] MaybeVertex unitAfter(std::optional<std::size_t> unit) const;
  /// The finest unit that a node is in, of those coarser than `scale`, a place in scales_.
  [[nodiscard]] MaybeVertex complexAfter(NodeId id, std::size_t scale) const;
  [[nodiscard]] bool isInSameUnits(NodeId now, NodeId then, std::size_t scale) const;
  [[nodiscard]] Entity ownEntity(NodeId id) const;
  /// An edited entity, with all values of its vertex if it is a further part that carries its name
  /// alone.
  [[nodiscard]] Entity wholeOf(Entity entity, const Entity& then, VertexId id) const;
  [[nodiscard]] MaybeVertex keptAncestor(VertexId id) const;
  [[nodiscard]] bool staysWithoutComplex(const MtgVertex& vertex) const;

  void claimUnits();
  void placeNodes();
  void dropVertices();
  void joinUnits();
  void joinUnit(std::size_t unit, std::optional<std::size_t> firstBefore);
  void joinNodes();
  void joinOthers();
  void joinFineParts(const std::vector<MaybeVertex>& nodeOf);
  void numberNewVertices();
  void writeNodes();
  bool writeInterpolated(bool all);
  [[nodiscard]] std::vector<VertexId> order();
  [[nodiscard]] Mtg assembled();

  const Mtg& base_;
  const MtgView& view_;
  RootUnits roots_;
  const Skeleton& edited_;
  std::vector<int> scales_; // of units
  UnitTable before_;
  UnitTable after_;
  Mtg mtg_;
  std::vector<VertexId> units_;                      // by place in after_.units()
  std::vector<MaybeVertex> nodes_;                   // by node id
  std::vector<std::optional<NodeId>> nodeBefore_;    // by vertex of the base
  std::vector<char> gone_;                           // by vertex of the base
  std::set<VertexId> toNumber_;                      // new ones, of a class that has indices
  std::vector<std::optional<std::uint32_t>> newIds_; // by vertex, once assembled
};

VertexId Edit::addVertex(const Entity& entity) {
  const VertexId id{static_cast<std::uint32_t>(mtg_.vertices.size())};
  mtg_.vertices.push_back({.scale = entity.scale});
  writeEntity(mtg_, id, entity, {});
  return id;
}

MaybeVertex Edit::unitBefore(std::optional<std::size_t> unit) const {
  if (!unit) return std::nullopt;
  const UnitTable::Unit& each = before_.units()[*unit];
  return view_.starts[indexOf(each.start)][each.entity];
}

MaybeVertex Edit::unitAfter(std::optional<std::size_t> unit) const {
  if (!unit) return std::nullopt;
  return units_[*unit];
}

MaybeVertex Edit::complexAfter(NodeId id, std::size_t scale) const {
  while (scale-- > 0)
    if (const auto unit = after_.at(id, scale)) return units_[*unit];
  return std::nullopt;
}

bool Edit::isInSameUnits(NodeId now, NodeId then, std::size_t scale) const {
  while (scale-- > 0)
    if (unitAfter(after_.at(now, scale)) != unitBefore(before_.at(then, scale))) return false;
  return true;
}

Entity Edit::wholeOf(Entity entity, const Entity& then, VertexId id) const {
  if (then == entityOf(base_, id)) return entity;
  const Entity whole = entityOf(mtg_, id);
  std::vector<FeatureValue> values = whole.values;
  for (const FeatureValue& typed : entity.values) {
    const auto at = std::ranges::find(values, typed.feature, &FeatureValue::feature);
    if (at == values.end())
      values.push_back(typed);
    else
      *at = typed;
  }
  entity.values = std::move(values);
  entity.later.insert(entity.later.begin(), whole.later.begin(), whole.later.end());
  return entity;
}

void Edit::claimUnits() {
  const std::vector<MaybeVertex> claims = unitClaims(base_, view_, before_, edited_, after_);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const UnitTable::Unit& unit = after_.units()[i];
    const Entity& entity = edited_[unit.start].entities[unit.entity];
    if (!claims[i]) {
      units_.push_back(addVertex(entity));
      if (roots_.toNumber.contains({unit.start, entity.scale})) toNumber_.insert(units_.back());
      continue;
    }
    units_.push_back(*claims[i]);
    if (!wasNode(unit.start)) continue;
    const std::vector<VertexId>& starts = view_.starts[indexOf(unit.start)];
    const auto at = std::ranges::find(starts, *claims[i]);
    if (at == starts.end()) continue;
    const auto& then = view_.skeleton[unit.start].entities[std::size_t(at - starts.begin())];
    if (entity != then) writeEntity(mtg_, *claims[i], wholeOf(entity, then, *claims[i]), {});
  }
}

Entity Edit::ownEntity(NodeId id) const {
  const Node& node = edited_[id];
  if (!node.entities.empty() && node.entities.back().scale == view_.scale)
    return node.entities.back();
  const auto parent = node.parent ? nodes_[indexOf(*node.parent)] : std::nullopt;
  if (parent) return {.scale = view_.scale, .symbol = mtg_.vertices[indexOf(*parent)].symbol};
  if (!view_.vertices.empty())
    return {.scale = view_.scale, .symbol = base_.vertices[indexOf(view_.vertices.front())].symbol};
  const auto found = std::ranges::find(base_.classes, view_.scale, &MtgClass::scale);
  return {.scale = view_.scale, .symbol = found == base_.classes.end() ? "N" : found->symbol};
}

void Edit::placeNodes() {
  nodes_.resize(edited_.idEnd());
  nodeBefore_.resize(base_.vertices.size());
  for (std::size_t i = 0; i < view_.vertices.size(); ++i)
    nodeBefore_[indexOf(view_.vertices[i])] = NodeId{static_cast<std::uint32_t>(i)};
  for (const NodeId id : edited_.ids())
    nodes_[indexOf(id)] = wasNode(id) ? view_.vertices[indexOf(id)] : addVertex(ownEntity(id));
}

/// Whether a vertex without position stays although its complex goes: its parent stays.
bool Edit::staysWithoutComplex(const MtgVertex& vertex) const {
  if (vertex.scale != view_.scale || !vertex.parent || isGone(*vertex.parent)) return false;
  return base_.vertices[indexOf(*vertex.parent)].complex == vertex.complex;
}

void Edit::dropVertices() {
  std::vector<char> hadNodes(base_.vertices.size(), 0);
  for (const std::vector<VertexId>& starts : view_.starts)
    for (const VertexId unit : starts)
      hadNodes[indexOf(unit)] = 1;
  const std::unordered_set<std::uint32_t> kept = [&] {
    std::unordered_set<std::uint32_t> set;
    for (const VertexId unit : units_)
      set.insert(static_cast<std::uint32_t>(unit));
    return set;
  }();
  gone_.assign(base_.vertices.size(), 0);
  for (std::size_t i = 0; i < gone_.size(); ++i) { // complexes and parents come first
    const MtgVertex& each = base_.vertices[i];
    if (nodeBefore_[i])
      gone_[i] = edited_.contains(*nodeBefore_[i]) ? 0 : 1;
    else if (hadNodes[i])
      gone_[i] = kept.contains(static_cast<std::uint32_t>(i)) ? 0 : 1;
    else
      gone_[i] = each.complex && isGone(*each.complex) && !staysWithoutComplex(each) ? 1 : 0;
  }
}

MaybeVertex Edit::keptAncestor(VertexId id) const {
  MaybeVertex at = base_.vertices[indexOf(id)].parent;
  while (at && isGone(*at))
    at = base_.vertices[indexOf(*at)].parent;
  return at;
}

void Edit::joinUnits() {
  std::map<VertexId, std::size_t> firstBefore; // parts of a unit join where its first one does
  for (std::size_t i = 0; i < before_.units().size(); ++i)
    firstBefore.emplace(*unitBefore(i), i);
  std::set<VertexId> joined;
  for (std::size_t i = 0; i < units_.size(); ++i) {
    if (!joined.insert(units_[i]).second) continue;
    const auto found = firstBefore.find(units_[i]);
    joinUnit(i, found == firstBefore.end() ? std::nullopt : std::optional(found->second));
  }
}

void Edit::joinUnit(std::size_t unit, std::optional<std::size_t> firstBefore) {
  const UnitTable::Unit& now = after_.units()[unit];
  MtgVertex& joined = vertex(units_[unit]);
  const auto parent = unitAfter(after_.below(edited_, now.start, now.scale));
  const EdgeType edge = parent ? edited_[now.start].edge : EdgeType::successor;
  bool hasMoved = true;
  bool hasOtherParent = true;
  if (firstBefore) {
    const UnitTable::Unit& then = before_.units()[*firstBefore];
    hasMoved = !isInSameUnits(now.start, then.start, now.scale);
    hasOtherParent = parent != unitBefore(before_.below(view_.skeleton, then.start, then.scale)) ||
                     (parent && edge != view_.skeleton[then.start].edge) ||
                     (joined.parent && isGone(*joined.parent));
  }
  if (hasMoved) joined.complex = complexAfter(now.start, now.scale);
  if (!hasOtherParent) return;
  joined.parent = parent;
  joined.edge = edge;
}

void Edit::joinNodes() {
  for (const NodeId id : edited_.ids()) {
    const Node& node = edited_[id];
    MtgVertex& joined = vertex(*nodes_[indexOf(id)]);
    const bool isOld = wasNode(id);
    if (!isOld || !isInSameUnits(id, id, scales_.size()))
      joined.complex = complexAfter(id, scales_.size());
    const bool hasSameParent = isOld && view_.skeleton[id].parent == node.parent &&
                               (!node.parent || view_.skeleton[id].edge == node.edge) &&
                               !(joined.parent && isGone(*joined.parent));
    if (hasSameParent) continue;
    joined.parent = node.parent ? nodes_[indexOf(*node.parent)] : std::nullopt;
    joined.edge = node.parent ? node.edge : EdgeType::successor;
  }
}

void Edit::joinOthers() {
  std::vector<MaybeVertex> nodeOf(base_.vertices.size()); // that a vertex is, or is a part of
  std::vector<char> isUnit(base_.vertices.size(), 0);
  for (const VertexId unit : units_)
    if (!isNew(unit)) isUnit[indexOf(unit)] = 1;
  for (std::size_t i = 0; i < base_.vertices.size(); ++i) {
    const VertexId id{static_cast<std::uint32_t>(i)};
    const MtgVertex& was = base_.vertices[i];
    if (was.scale == view_.scale) nodeOf[i] = id;
    if (was.scale > view_.scale && was.complex) nodeOf[i] = nodeOf[indexOf(*was.complex)];
    if (gone_[i] || nodeBefore_[i] || isUnit[i]) continue;
    if (was.parent && isGone(*was.parent)) {
      vertex(id).parent = keptAncestor(id);
      if (!vertex(id).parent) vertex(id).edge = EdgeType::successor;
    }
    if (was.complex && isGone(*was.complex)) // it stays for its parent's sake
      vertex(id).complex = was.parent ? vertex(*was.parent).complex : std::nullopt;
  }
  joinFineParts(nodeOf);
}

void Edit::joinFineParts(const std::vector<MaybeVertex>& nodeOf) {
  std::map<std::pair<VertexId, int>, VertexId> last; // part of a node, of a scale
  for (std::size_t i = 0; i < nodeOf.size(); ++i)
    if (nodeOf[i] && !gone_[i])
      last[{*nodeOf[i], base_.vertices[i].scale}] = VertexId{static_cast<std::uint32_t>(i)};
  for (std::size_t i = 0; i < nodeOf.size(); ++i) {
    const MtgVertex& was = base_.vertices[i];
    if (was.scale <= view_.scale || gone_[i] || !nodeOf[i] || !was.parent) continue;
    const MaybeVertex below = nodeOf[indexOf(*was.parent)];
    const MaybeVertex bearer = vertex(*nodeOf[i]).parent;
    if (below == nodeOf[i] || (below && below == bearer)) continue;
    if (base_.vertices[indexOf(*nodeOf[i])].parent == bearer && !isGone(*was.parent)) continue;
    MtgVertex& part = mtg_.vertices[i];
    const auto found = bearer ? last.find({*bearer, was.scale}) : last.end();
    part.parent = found == last.end() ? std::nullopt : std::optional(found->second);
    part.edge = part.parent ? vertex(*nodeOf[i]).edge : EdgeType::successor;
  }
}

void Edit::numberNewVertices() {
  std::set<std::string> indexed; // classes that have indices here
  for (const MtgVertex& each : base_.vertices)
    if (each.index) indexed.insert(each.symbol);
  using Siblings = std::pair<MaybeVertex, std::string>;
  std::map<Siblings, IndicesInUse> ofComplex;
  std::map<Siblings, IndicesInUse> ofParent;
  const auto isBranch = [](const MtgVertex& each) {
    return each.parent && each.edge == EdgeType::branching;
  };
  const auto take = [&](const MtgVertex& each) {
    ofComplex[{each.complex, each.symbol}].take(*each.index);
    if (isBranch(each)) ofParent[{each.parent, each.symbol}].take(*each.index);
  };
  for (std::size_t i = 0; i < mtg_.vertices.size(); ++i) {
    const MtgVertex& each = mtg_.vertices[i];
    if (each.index && !isGone(VertexId{static_cast<std::uint32_t>(i)})) take(each);
  }
  for (std::size_t i = base_.vertices.size(); i < mtg_.vertices.size(); ++i) {
    MtgVertex& each = mtg_.vertices[i];
    const bool isNumbered = indexed.contains(each.symbol) ||
                            toNumber_.contains(VertexId{static_cast<std::uint32_t>(i)});
    if (each.index || !isNumbered) continue;
    if (isBranch(each)) each.index = ofParent[{each.parent, each.symbol}].nextAtPlace();
    if (!each.index) each.index = ofComplex[{each.complex, each.symbol}].next();
    if (each.index) take(each);
  }
}

void Edit::writeNodes() {
  const std::set<NodeId> interpolated(view_.interpolated.begin(), view_.interpolated.end());
  for (const NodeId id : edited_.ids()) {
    const Node& node = edited_[id];
    const VertexId at = *nodes_[indexOf(id)];
    if (!wasNode(id)) {
      writePosition(mtg_, at, node.position);
      if (node.radius != 0) writeRadius(mtg_, at, node.radius);
      continue;
    }
    const Node& was = view_.skeleton[id];
    if (!node.entities.empty() && node.entities.back() != was.entities.back() &&
        node.entities.back().scale == view_.scale)
      writeEntity(mtg_, at, node.entities.back(), geometricFeatures(mtg_, vertex(at)));
    if (node.position != was.position && !interpolated.contains(id)) // see writeInterpolated()
      writePosition(mtg_, at, node.position);
    if (node.radius != was.radius) writeRadius(mtg_, at, node.radius);
  }
}

/// Writes the positions of vertices without one that no longer follow from their neighbors, or all.
/// @return whether there were such
bool Edit::writeInterpolated(bool all) {
  const Mtg now = assembled();
  const MtgView view = hasPositions(now, "") ? viewOf(now, "").value : MtgView{};
  std::vector<std::optional<NodeId>> nodeAt(now.vertices.size());
  for (std::size_t i = 0; i < view.vertices.size(); ++i)
    nodeAt[indexOf(view.vertices[i])] = NodeId{static_cast<std::uint32_t>(i)};
  std::vector<NodeId> wrong;
  std::vector<NodeId> open; // still without a position
  for (const NodeId id : view_.interpolated) {
    if (!edited_.contains(id)) continue;
    open.push_back(id);
    const auto node = nodeAt[*newIds_[indexOf(*nodes_[indexOf(id)])]];
    if (!node || view.skeleton[*node].position != edited_[id].position) wrong.push_back(id);
  }
  for (const NodeId id : all && !wrong.empty() ? open : wrong)
    writePosition(mtg_, *nodes_[indexOf(id)], edited_[id].position);
  return !wrong.empty();
}

/// The vertices that stay, each after its complex and its parent, else as the base has them; new
/// ones right after their parent.
std::vector<VertexId> Edit::order() {
  enum class State : std::uint8_t { open, waiting, done };
  std::vector<State> states(mtg_.vertices.size(), State::open);
  std::vector<std::vector<VertexId>> added(mtg_.vertices.size()); // by parent
  for (std::size_t i = mtg_.vertices.size(); i-- > base_.vertices.size();)
    if (const auto parent = mtg_.vertices[i].parent)
      added[indexOf(*parent)].push_back(VertexId{static_cast<std::uint32_t>(i)});
  std::vector<VertexId> result;
  std::vector<VertexId> stack;
  const auto put = [&](VertexId id) {
    if (states[indexOf(id)] == State::open) stack.push_back(id);
  };
  for (std::size_t i = 0; i < mtg_.vertices.size(); ++i) {
    if (!isGone(VertexId{static_cast<std::uint32_t>(i)}))
      put(VertexId{static_cast<std::uint32_t>(i)});
    while (!stack.empty()) {
      const VertexId id = stack.back();
      State& state = states[indexOf(id)];
      MtgVertex& each = vertex(id);
      // Units of a strange file, in many parts, may come to be attached in a cycle: one is let go.
      if (each.parent && states[indexOf(*each.parent)] == State::waiting) each.parent.reset();
      const std::size_t height = stack.size();
      if (state == State::open || state == State::waiting) {
        state = State::waiting;
        if (each.complex) put(*each.complex);
        if (stack.size() == height && each.parent) put(*each.parent);
      }
      if (stack.size() > height) continue;
      stack.pop_back();
      if (state == State::done) continue;
      state = State::done;
      result.push_back(id);
      for (const VertexId child : added[indexOf(id)])
        put(child);
    }
  }
  return result;
}

Mtg Edit::assembled() {
  const std::vector<VertexId> ids = order();
  newIds_.assign(mtg_.vertices.size(), std::nullopt);
  for (std::size_t i = 0; i < ids.size(); ++i)
    newIds_[indexOf(ids[i])] = static_cast<std::uint32_t>(i);
  const auto renumber = [&](MaybeVertex& id) {
    if (id) id = VertexId{*newIds_[indexOf(*id)]};
  };
  Mtg result{mtg_.classes, mtg_.rules, mtg_.features, {}};
  result.vertices.reserve(ids.size());
  for (const VertexId id : ids) {
    result.vertices.push_back(vertex(id));
    renumber(result.vertices.back().complex);
    renumber(result.vertices.back().parent);
  }
  return result;
}

Mtg Edit::result() {
  if (!view_.interpolated.empty() && !edited_.isEmpty() && writeInterpolated(false))
    (void)writeInterpolated(true);
  return withRulesOfNewClasses(base_, assembled());
}

} // namespace

Mtg withEdits(const Mtg& base, const Skeleton& edited) {
  return withEdits(base, openedView(base), edited);
}

Mtg withEdits(const Mtg& base, const MtgView& view, const Skeleton& edited) {
  requireFinite(edited);
  if (view.skeleton == edited) return base;
  const ScaleShift shift(base, view.scale, edited);
  if (shift.isNone()) return Edit(base, view, edited).result();
  const Mtg shiftedBase = withScales(base, shift);
  const MtgView shiftedView = withScales(view, shift);
  return Edit(shiftedBase, shiftedView, edited).result();
}

} // namespace espalier
