#include "core/evaluate/traits/stem_diameter.h"

#include "core/base/shown.h"
#include "core/evaluate/traits/axis_traits.h"

#include <cmath>

namespace espalier {

StemDiameter stemDiameterAt(const Skeleton& plant, double z, StemOf of) {
  const bool isReference = of == StemOf::reference;
  const Axis stem = stemOf(plant);
  if (stem.empty() || plant[stem.front()].position.z() > z)
    return {{},
            isReference ? Shown::tr("the reference begins above breast height")
                        : Shown::tr("the plant begins above breast height")};
  for (std::size_t i = 1; i < stem.size(); ++i) {
    const Node& below = plant[stem[i - 1]];
    const Node& above = plant[stem[i]];
    if (above.position.z() < z || above.position.z() <= below.position.z()) continue;
    if (!(below.radius > 0 && above.radius > 0))
      return {{},
              isReference ? Shown::tr("the reference has no radius at breast height")
                          : Shown::tr("the plant has no radius at breast height")};
    const double share = (z - below.position.z()) / (above.position.z() - below.position.z());
    return {2 * std::lerp(below.radius, above.radius, share), {}};
  }
  return {{},
          isReference ? Shown::tr("the stem of the reference does not rise that high")
                      : Shown::tr("the stem of the plant does not rise that high")};
}

} // namespace espalier
