#pragma once

#include "ui/view/camera.h"
#include "ui/view/scene.h"

#include <cstdint>

namespace espalier {

/// Whether a view shows anything of its plant, or why it does not.
enum class InView : std::uint8_t {
  plant,     // it does, or there is no plant
  layersOff, // none of what there is is switched on
  clipped,   // what is here lies outside of the slab or the box
  hidden,    // what is here is hidden
  beside     // the camera looks past the plant
};

/// Of scans with more than a million points it looks at so many. Time O(points), some 5 ns each,
/// where nothing is seen; else less.
[[nodiscard]] InView inView(const Scene& scene, const ScreenMap& screen);

} // namespace espalier
