#include "core/mtg/mtg_unit_claims.h"

#include <utility>

namespace espalier {
namespace {

using MaybeVertex = std::optional<VertexId>;

class Claims {
public:
  Claims(const Mtg& base, const MtgView& view, const UnitTable& before, const Skeleton& edited,
         const UnitTable& after)
      : base_(base), view_(view), before_(before), edited_(edited), after_(after),
        claims_(after.units().size()), isTaken_(base.vertices.size(), 0) {}

  std::vector<MaybeVertex> made() {
    claimByStart();
    claimByNodes();
    return std::move(claims_);
  }

private:
  [[nodiscard]] MaybeVertex vertexBefore(NodeId id, std::size_t scale) const {
    const auto unit = before_.at(id, scale);
    if (!unit) return std::nullopt;
    const UnitTable::Unit& each = before_.units()[*unit];
    return view_.starts[indexOf(each.start)][each.entity];
  }

  void claimByStart() {
    for (std::size_t i = 0; i < claims_.size(); ++i) {
      const UnitTable::Unit& unit = after_.units()[i];
      if (!view_.skeleton.contains(unit.start)) continue;
      for (const VertexId vertex : view_.starts[indexOf(unit.start)]) {
        if (base_.vertices[indexOf(vertex)].scale != after_.scales()[unit.scale]) continue;
        claims_[i] = vertex;
        isTaken_[indexOf(vertex)] = 1;
      }
    }
  }

  [[nodiscard]] bool carries(const UnitTable::Unit& unit, VertexId vertex) const {
    const Entity& entity = edited_[unit.start].entities[unit.entity];
    Entity other = entityOf(base_, vertex);
    if (entity == other) return true;
    other.values.clear();
    other.later.clear();
    return entity == other; // a further part
  }

  void claimByNodes() {
    std::vector<MaybeVertex> candidates(claims_.size());
    std::vector<MaybeVertex> refused(claims_.size()); // looked at last
    for (const NodeId id : edited_.ids()) {
      if (!view_.skeleton.contains(id)) continue;
      for (std::size_t scale = 0; scale < after_.scales().size(); ++scale) {
        const auto unit = after_.at(id, scale);
        if (!unit || claims_[*unit] || candidates[*unit]) continue;
        const MaybeVertex vertex = vertexBefore(id, scale);
        if (!vertex || isTaken_[indexOf(*vertex)] || refused[*unit] == vertex) continue;
        (carries(after_.units()[*unit], *vertex) ? candidates : refused)[*unit] = vertex;
      }
    }
    for (std::size_t i = 0; i < claims_.size(); ++i) { // that of the parent comes first
      if (claims_[i] || !candidates[i]) continue;
      const UnitTable::Unit& unit = after_.units()[i];
      const auto below = after_.below(edited_, unit.start, unit.scale);
      if (!below || claims_[*below] != candidates[i]) claims_[i] = candidates[i];
    }
  }

  const Mtg& base_;
  const MtgView& view_;
  const UnitTable& before_;
  const Skeleton& edited_;
  const UnitTable& after_;
  std::vector<MaybeVertex> claims_;
  std::vector<char> isTaken_; // by vertex
};

} // namespace

std::vector<MaybeVertex> unitClaims(const Mtg& base, const MtgView& view, const UnitTable& before,
                                    const Skeleton& edited, const UnitTable& after) {
  return Claims(base, view, before, edited, after).made();
}

} // namespace espalier
