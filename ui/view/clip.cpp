#include "ui/view/clip.h"

#include <algorithm>

namespace espalier {

bool Clip::operator==(const Clip& other) const {
  if (slab != other.slab || box.has_value() != other.box.has_value()) return false;
  return !box || (box->min() == other.box->min() && box->max() == other.box->max());
}

ClipVolume::ClipVolume(const Clip& clip, const Eigen::AlignedBox3d& bounds,
                       const Eigen::Vector3d& origin, const Camera& camera)
    : isAll_(clip.isAll()) {
  if (isAll_) return;
  const Eigen::Vector3d forward = camera.forward();
  forward_ = forward.cast<float>();
  eye_ = static_cast<float>(forward.dot(camera.eye() - origin));
  if (clip.slab && !bounds.isEmpty()) {
    const double middle = forward.dot(bounds.center() - camera.eye());
    const double half = std::max(forward.cwiseAbs().dot(bounds.sizes()) / 2, 1e-9);
    const double rounding = 1e-5 * half; // what lies on a plane of the slab is in it
    depths_ = {static_cast<float>(middle + (2 * clip.slab->nearest - 1) * half - rounding),
               static_cast<float>(middle + (2 * clip.slab->farthest - 1) * half + rounding)};
  }
  if (clip.box) {
    low_ = (clip.box->min() - origin).cast<float>();
    high_ = (clip.box->max() - origin).cast<float>();
  }
}

} // namespace espalier
