#include "core/mtg/mtg_scale_shift.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

constexpr int mostAdded = 32; // scales; no edit makes more

/// By how much the scale of the nodes has risen; 0 if nothing shows it.
int riseOfNodes(int nodeScale, const Skeleton& edited) {
  int own = nodeScale;
  for (const NodeId id : edited.ids())
    if (!edited[id].entities.empty()) own = std::max(own, edited[id].entities.back().scale);
  return own - nodeScale <= mostAdded ? own - nodeScale : 0;
}

/// How many entities say that a scale of the base has risen by so much.
std::map<std::pair<int, int>, std::size_t> votes(const Mtg& base, const Skeleton& edited) {
  std::map<std::string, int> scales;
  for (const MtgVertex& vertex : base.vertices)
    scales.emplace(vertex.symbol, vertex.scale);
  std::map<std::pair<int, int>, std::size_t> result;
  for (const NodeId id : edited.ids())
    for (const Entity& entity : edited[id].entities)
      if (const auto found = scales.find(entity.symbol);
          found != scales.end() && entity.scale >= found->second)
        ++result[{found->second, entity.scale - found->second}];
  return result;
}

std::vector<int> scalesUpTo(const Mtg& base, int nodeScale) {
  std::set<int> scales = {nodeScale};
  for (const MtgVertex& vertex : base.vertices)
    if (vertex.scale > 0 && vertex.scale < nodeScale) scales.insert(vertex.scale);
  return {scales.begin(), scales.end()};
}

} // namespace

ScaleShift::ScaleShift(const Mtg& base, int nodeScale, const Skeleton& edited) {
  const int rise = riseOfNodes(nodeScale, edited);
  if (rise == 0) return;
  const auto agreed = votes(base, edited);
  const std::vector<int> scales = scalesUpTo(base, nodeScale);
  // Of all ways in which the shift grows with the scale, up to that of the nodes, the one that most
  // entities agree with: best[i][by] is their number up to scale i, from[i][by] the shift before.
  const std::size_t width = std::size_t(rise) + 1;
  std::vector<std::vector<std::size_t>> best(scales.size(), std::vector<std::size_t>(width));
  std::vector<std::vector<std::size_t>> from = best;
  for (std::size_t i = 0; i < scales.size(); ++i)
    for (std::size_t by = 0; by < width; ++by) {
      if (i > 0) {
        const auto begin = best[i - 1].begin();
        const auto found = std::max_element(begin, begin + std::ptrdiff_t(by) + 1);
        from[i][by] = std::size_t(found - begin);
        best[i][by] = *found;
      }
      const auto vote = agreed.find({scales[i], int(by)});
      if (vote != agreed.end()) best[i][by] += vote->second;
    }
  std::size_t by = width - 1;
  for (std::size_t i = scales.size(); i-- > 0; by = from[i][by])
    shifts_[scales[i]] = int(by);
}

int ScaleShift::operator()(int scale) const {
  const auto next = shifts_.upper_bound(scale);
  return next == shifts_.begin() ? scale : scale + std::prev(next)->second;
}

Mtg withScales(Mtg mtg, const ScaleShift& shift) {
  for (MtgClass& each : mtg.classes)
    each.scale = shift(each.scale);
  for (MtgVertex& vertex : mtg.vertices)
    vertex.scale = shift(vertex.scale);
  return mtg;
}

MtgView withScales(MtgView view, const ScaleShift& shift) {
  view.scale = shift(view.scale);
  for (const NodeId id : view.skeleton.ids()) {
    std::vector<Entity> entities = view.skeleton[id].entities;
    for (Entity& entity : entities)
      entity.scale = shift(entity.scale);
    view.skeleton.setEntities(id, std::move(entities));
  }
  return view;
}

} // namespace espalier
