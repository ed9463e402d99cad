#pragma once

#include "core/cloud/point_cloud.h"
#include "ui/view/color_map.h"
#include "ui/view/palette.h"
#include "ui/view/point_colors.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
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

/// Red, green, blue and whether a point is drawn (255) or not (0).
using PointLook = std::array<std::uint8_t, 4>;

/// Where points of a scene's cloud are drawn. Contracted ones, of the plant or of a state in its
/// place, are all in the accent, but hidden, dim, ... as they are.
enum class PointPlace : std::uint8_t { scanned, contracted, contractedInState };

/// The look of each point of a scene's cloud. The scene must outlive it, and stay as it is.
class PointLooks {
public:
  PointLooks(const Scene& scene, PointPlace place); // pre: the scene has a cloud

  [[nodiscard]] PointLook operator[](Eigen::Index point) const;           // pre: of the cloud
  [[nodiscard]] bool areSomeSelected() const { return areSomeSelected_; } // the others step back

private:
  [[nodiscard]] Color colorOf(Eigen::Index point) const; // whatever its state

  const Scene& scene_;
  bool isHiddenAtRest_; // where it is contracted to where it was scanned: it is shown there alone
  Palette palette_;
  Color plain_; // where nothing colors it
  std::optional<LegendColors> values_;
  std::optional<PointColors> colors_;
  bool areSomeSelected_;
};

/// The looks of the other scan that lies over it. pre: it is colored by value
[[nodiscard]] std::vector<PointLook> movedLooks(const Scene& scene);

} // namespace espalier
