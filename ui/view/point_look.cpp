#include "ui/view/point_look.h"

#include "ui/view/palette.h"
#include "ui/view/scene.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr double dimness = 0.72; // toward the background
constexpr double half = 0.5;     // likewise

Color mixed(const Color& color, const Color& with, double part) {
  Color result{};
  for (std::size_t c = 0; c < result.size(); ++c)
    result[c] = static_cast<std::uint8_t>(std::lround((1 - part) * color[c] + part * with[c]));
  return result;
}

std::vector<Color> colorsOf(const Scene& scene) {
  const Color& plain = palette(scene.dark).point;
  const std::optional<Legend> legend = scene.pointLegend();
  if (!scene.pointValues)
    return pointColors(*scene.cloud, scene.pointColor, legend, scene.dark, plain, scene.up);
  std::vector<Color> colors(static_cast<std::size_t>(scene.cloud->size()), plain);
  const LegendColors map(*legend, scene.dark);
  const std::vector<float>& values = *scene.pointValues->values;
  for (std::size_t i = 0; i < colors.size(); ++i)
    if (!std::isnan(values[i])) colors[i] = map(values[i]);
  return colors;
}

std::vector<std::array<std::uint8_t, 4>> looksOf(const Scene& scene,
                                                 const std::vector<Color>& colors) {
  const Palette fixed = palette(scene.dark);
  std::vector<std::array<std::uint8_t, 4>> looks;
  looks.reserve(colors.size());
  const bool areSomeSelected =
      scene.pointStates && std::ranges::count(*scene.pointStates, PointState::selected) > 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const PointState state = scene.pointStates ? (*scene.pointStates)[i] : PointState::normal;
    Color color = colors[i];
    if (state == PointState::normal && areSomeSelected)
      color = mixed(color, fixed.backgroundBottom, half); // the others step back
    if (state == PointState::dim) color = mixed(color, fixed.backgroundBottom, dimness);
    if (state == PointState::aside) color = mixed(fixed.branching, fixed.backgroundBottom, half);
    if (state == PointState::selected) color = fixed.selected;
    const std::uint8_t shown = state == PointState::hidden ? 0 : 255;
    looks.push_back({color[0], color[1], color[2], shown});
  }
  return looks;
}

} // namespace

std::vector<std::array<std::uint8_t, 4>> pointLooks(const Scene& scene) {
  return looksOf(scene, colorsOf(scene));
}

std::vector<std::array<std::uint8_t, 4>> movedLooks(const Scene& scene) {
  const LegendColors map(*scene.movedLegend(), scene.dark);
  const Color& plain = palette(scene.dark).movedScan;
  std::vector<std::array<std::uint8_t, 4>> looks;
  looks.reserve(scene.moved.shown.values->values->size());
  for (const float value : *scene.moved.shown.values->values) {
    const Color color = std::isnan(value) ? plain : map(value);
    looks.push_back({color[0], color[1], color[2], 255});
  }
  return looks;
}

std::vector<std::array<std::uint8_t, 4>> contractedLooks(const Scene& scene) {
  return looksOf(scene, std::vector<Color>(static_cast<std::size_t>(scene.cloud->size()),
                                           palette(scene.dark).contracted));
}

} // namespace espalier
