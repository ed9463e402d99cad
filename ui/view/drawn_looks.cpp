#include "ui/view/drawn_looks.h"

#include "core/base/pieces.h"
#include "ui/view/drawing_order.h"
#include "ui/view/scene.h"

namespace espalier {
namespace {

constexpr Eigen::Index grain = 1 << 14;

} // namespace

bool DrawnLooks::isOnlyOtherStates(const Scene& scene, bool areSomeSelected) const {
  return !looks_.empty() && revision_ == scene.colorRevision - scene.stateRevision &&
         states_ != nullptr && scene.pointStates != nullptr &&
         areSomeSelected_ == areSomeSelected; // else all others step back, or come forward
}

void DrawnLooks::refresh(const Scene& scene) {
  const PointLooks looks(scene, place_);
  const DrawingOrder order(scene.cloud->size());
  if (isOnlyOtherStates(scene, looks.areSomeSelected())) {
    const std::vector<PointState>& now = *scene.pointStates;
    runInPieces(order.size(), grain, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index i = begin; i < end; ++i)
        if (now[static_cast<std::size_t>(i)] != (*states_)[static_cast<std::size_t>(i)])
          looks_[static_cast<std::size_t>(order.rankOf(i))] = looks[i];
    });
  } else {
    // In the order of the cloud first: places beside each other are in memory, too.
    std::vector<PointLook> all(static_cast<std::size_t>(order.size()));
    runInPieces(order.size(), grain, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index point = begin; point < end; ++point)
        all[static_cast<std::size_t>(point)] = looks[point];
    });
    looks_.resize(all.size());
    runInPieces(order.size(), grain, [&](Eigen::Index begin, Eigen::Index end) {
      Eigen::Index point = order.pointAt(begin);
      for (Eigen::Index rank = begin; rank < end; ++rank, point = order.after(point))
        looks_[static_cast<std::size_t>(rank)] = all[static_cast<std::size_t>(point)];
    });
  }
  states_ = scene.pointStates;
  areSomeSelected_ = looks.areSomeSelected();
  revision_ = scene.colorRevision - scene.stateRevision;
}

} // namespace espalier
