#include "ui/view/point_look.h"

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
    result[c] = static_cast<std::uint8_t>((1 - part) * color[c] + part * with[c] + 0.5);
  return result;
}

} // namespace

PointLooks::PointLooks(const Scene& scene, PointPlace place)
    : scene_(scene), isHiddenAtRest_(place == PointPlace::contracted && scene.areSomeAtRest),
      palette_(palette(scene.dark)),
      plain_(place == PointPlace::scanned ? palette_.point : palette_.contracted),
      areSomeSelected_(scene.pointStates &&
                       std::ranges::find(*scene.pointStates, PointState::selected) !=
                           scene.pointStates->end()) {
  if (place != PointPlace::scanned) return;
  const std::optional<Legend> legend = scene.pointLegend();
  if (scene.pointValues)
    values_.emplace(*legend, scene.dark);
  else
    colors_.emplace(*scene.cloud, scene.pointColor, legend, scene.dark, plain_, scene.up);
}

Color PointLooks::colorOf(Eigen::Index point) const {
  if (colors_) return (*colors_)[point];
  if (!values_) return plain_;
  const float value = (*scene_.pointValues->values)[static_cast<std::size_t>(point)];
  return std::isnan(value) ? plain_ : (*values_)(value);
}

PointLook PointLooks::operator[](Eigen::Index point) const {
  const PointState state = scene_.pointStates
                               ? (*scene_.pointStates)[static_cast<std::size_t>(point)]
                               : PointState::normal;
  Color color{};
  if (state == PointState::selected)
    color = palette_.selected;
  else if (state == PointState::aside)
    color = mixed(palette_.branching, palette_.backgroundBottom, half);
  else if (state == PointState::dim)
    color = mixed(colorOf(point), palette_.backgroundBottom, dimness);
  else if (state == PointState::normal && areSomeSelected_)
    color = mixed(colorOf(point), palette_.backgroundBottom, half); // the others step back
  else
    color = colorOf(point);
  const bool isShown =
      state != PointState::hidden && !(isHiddenAtRest_ && scene_.isContractedAtRest(point));
  return {color[0], color[1], color[2], static_cast<std::uint8_t>(isShown ? 255 : 0)};
}

std::vector<PointLook> movedLooks(const Scene& scene) {
  const LegendColors map(*scene.movedLegend(), scene.dark);
  const Color& plain = palette(scene.dark).movedScan;
  std::vector<PointLook> looks;
  looks.reserve(scene.moved.shown.values->values->size());
  for (const float value : *scene.moved.shown.values->values) {
    const Color color = std::isnan(value) ? plain : map(value);
    looks.push_back({color[0], color[1], color[2], 255});
  }
  return looks;
}

} // namespace espalier
