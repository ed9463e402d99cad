#pragma once

#include "core/cloud/point_cloud.h"
#include "ui/view/color_map.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace espalier {

struct Scene;

/// How a point is drawn. A hidden one is not picked and in no area.
enum class PointState : std::uint8_t { normal, dim, hidden, selected, aside };

/// What points are colored by, in place of what the cloud has: distances, densities, ...
struct PointValues {
  std::shared_ptr<const std::vector<float>> values; // one per point; not a number: plain
  Legend legend;
};

/// Red, green, blue and whether it is drawn (255) or not (0), of each point of a scene's cloud.
[[nodiscard]] std::vector<std::array<std::uint8_t, 4>> pointLooks(const Scene& scene);

/// Likewise, of the other scan that lies over it. pre: it is colored by value
[[nodiscard]] std::vector<std::array<std::uint8_t, 4>> movedLooks(const Scene& scene);

/// The same points where they are contracted: all in the accent, but hidden, dim, ... as they are.
[[nodiscard]] std::vector<std::array<std::uint8_t, 4>> contractedLooks(const Scene& scene);

} // namespace espalier
