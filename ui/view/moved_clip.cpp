#include "ui/view/moved_clip.h"

#include <algorithm>

namespace espalier {
namespace {

struct Range {
  double least;
  double most;
};

/// `shown` moved to hold `wanted` and some of what is around it, within `whole`.
Range moved(const Range& shown, const Range& wanted, const Range& whole) {
  if (wanted.least >= shown.least && wanted.most <= shown.most) return shown;
  const double around = 0.02 * (whole.most - whole.least);
  const double width = std::max(shown.most - shown.least, wanted.most - wanted.least + 2 * around);
  double least = wanted.least < shown.least ? wanted.least - around : wanted.most + around - width;
  // Where the plant ends nothing is to be seen: the rest of the width is on its other side.
  least = std::max(whole.least, std::min(least, whole.most - width));
  return {std::min(least, wanted.least), std::max(least + width, wanted.most)};
}

Clip::Slab slabToShow(const Clip::Slab& slab, const std::vector<Eigen::Vector3d>& places,
                      const Eigen::AlignedBox3d& bounds, const Camera& camera) {
  const Eigen::Vector3d forward = camera.forward();
  const double half = std::max(forward.cwiseAbs().dot(bounds.sizes()) / 2, 1e-9); // as ClipVolume
  Range wanted{1, 0};
  for (const Eigen::Vector3d& place : places) {
    const double part = std::clamp((1 + forward.dot(place - bounds.center()) / half) / 2, 0.0, 1.0);
    wanted = {std::min(wanted.least, part), std::max(wanted.most, part)};
  }
  const Range range = moved({slab.nearest, slab.farthest}, wanted, {0, 1});
  return {std::max(range.least, 0.0), std::min(range.most, 1.0)};
}

Eigen::AlignedBox3d boxToShow(const Eigen::AlignedBox3d& box,
                              const std::vector<Eigen::Vector3d>& places,
                              const Eigen::AlignedBox3d& bounds) {
  Eigen::AlignedBox3d wanted;
  for (const Eigen::Vector3d& place : places)
    wanted.extend(place);
  Eigen::AlignedBox3d result = box;
  for (int axis = 0; axis < 3; ++axis) {
    const Range range =
        moved({box.min()[axis], box.max()[axis]}, {wanted.min()[axis], wanted.max()[axis]},
              {bounds.min()[axis], bounds.max()[axis]});
    result.min()[axis] = range.least;
    result.max()[axis] = range.most;
  }
  return result;
}

} // namespace

Clip movedToShow(const Clip& clip, const std::vector<Eigen::Vector3d>& places,
                 const Eigen::AlignedBox3d& bounds, const Camera& camera) {
  Clip result = clip;
  if (places.empty() || bounds.isEmpty()) return result;
  if (clip.slab) result.slab = slabToShow(*clip.slab, places, bounds, camera);
  if (clip.box) result.box = boxToShow(*clip.box, places, bounds);
  return result;
}

} // namespace espalier
