#include "ui/view/state_parts.h"

#include <cmath>

namespace espalier {

std::vector<StatePart> stateParts(const Scene& scene, double divider) {
  if (!scene.other(Side::left).isShown && !scene.other(Side::right).isShown) return {{}};
  std::vector<StatePart> parts;
  for (const Side side : {Side::left, Side::right}) {
    const bool isLeft = side == Side::left;
    const StatePart part{.from = isLeft ? 0 : float(divider), .to = isLeft ? float(divider) : 1};
    if (part.from >= part.to) continue;
    const OtherState& other = scene.other(side);
    StatePart plant = part;
    plant.hole = other.isShown ? other.within : std::nullopt;
    if (!other.isShown || other.within) parts.push_back(plant);
    if (!other.isShown) continue;
    parts.push_back(part);
    parts.back().other = side;
  }
  return parts;
}

std::vector<StatePart> pointParts(const Scene& scene, double divider) {
  std::vector<StatePart> parts;
  for (StatePart part : stateParts(scene, divider)) {
    const Side side = part.from < static_cast<float>(divider) ? Side::left : Side::right;
    const OtherState& other = scene.other(side);
    const bool isReplaced = other.isShown && other.replacesPoints;
    if (!isReplaced) part.hole.reset();
    // Where there are the plant and a part of another state, the plant's turn is enough.
    if (!part.other || (!isReplaced && !other.within)) parts.push_back(part);
  }
  return parts;
}

OnlyIn::OnlyIn(const StatePart& part, const DrawSettings& settings)
    : isOn_(settings.window->GetState(), GL_SCISSOR_TEST), box_(settings.window->GetState()) {
  vtkOpenGLState* state = settings.window->GetState();
  const auto left = static_cast<int>(std::lround(part.from * settings.size.x()));
  const auto right = static_cast<int>(std::lround(part.to * settings.size.x()));
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(left, 0, right - left, static_cast<int>(settings.size.y()));
}

OnlyIn::~OnlyIn() = default;

} // namespace espalier
