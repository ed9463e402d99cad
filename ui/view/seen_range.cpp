#include "ui/view/seen_range.h"

#include "ui/view/point_colors.h"
#include "ui/view/screen_part.h"

#include <algorithm>
#include <vector>

namespace espalier {

std::optional<ValueRange> seenRange(const Scene& scene, const ScreenMap& screen) {
  constexpr Eigen::Index most = 300'000;
  constexpr std::size_t fewest = 50; // points that say anything
  constexpr double closeUp = 1 / 1.5;
  if (!scene.cloud || scene.points.size() == 0 || scene.pointValues || !scene.colorLegend ||
      !scene.points.visible)
    return std::nullopt;
  const ScreenPart part(screen, scene.origin(), QRectF(0, 0, screen.size().x(), screen.size().y()));
  const ClipVolume clip = scene.clipVolume(screen.camera());
  const FocusDepths focus = scene.focusDepths(screen.camera());
  const Eigen::Index step = (scene.points.size() + most - 1) / most;
  std::vector<double> values;
  for (Eigen::Index i = 0; i < scene.points.size(); i += step) {
    const Eigen::Vector3f at = scene.points.positions->col(i);
    const ScreenPart::Place place = part.place(at);
    if (!scene.isPointShown(i) || !part.isBeforeEye(place) ||
        !part.box().contains(place.pixel.x(), place.pixel.y()) || !clip.contains(at) ||
        focus.outOfFocus(place.depth) > 0)
      continue;
    values.push_back(pointValue(*scene.cloud, scene.pointColor, i, scene.up));
  }
  if (values.size() < fewest) return std::nullopt;
  const auto percentile = [&](double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, values.begin() + at);
    return values[static_cast<std::size_t>(at)];
  };
  const ValueRange seen{percentile(0.01), percentile(0.99)};
  const double usual = scene.colorLegend->to - scene.colorLegend->from;
  if (seen.to <= seen.from || seen.to - seen.from > closeUp * usual) return std::nullopt;
  return seen;
}

} // namespace espalier
