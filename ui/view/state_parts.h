#pragma once

#include "ui/view/gl_objects.h"
#include "ui/view/scene.h"

#include <vtkOpenGLState.h>

#include <optional>
#include <vector>

namespace espalier {

/// A part of the screen, and what is drawn in it: the plant itself, or another state of it.
struct StatePart {
  float from = 0; // of the width, from the left
  float to = 1;
  std::optional<Side> other; // none: the plant itself
  std::optional<Ball> hole;  // what lies in it is not drawn: another state is
};

/// @param divider of the view, as PlantView::setDivider
[[nodiscard]] std::vector<StatePart> stateParts(const Scene& scene, double divider);

/// Where the points of the cloud are drawn.
[[nodiscard]] std::vector<StatePart> pointParts(const Scene& scene, double divider);

/// Draws in a part of the screen alone, as long as it lives.
class OnlyIn {
public:
  OnlyIn(const StatePart& part, const DrawSettings& settings);
  ~OnlyIn();
  OnlyIn(const OnlyIn&) = delete;
  OnlyIn& operator=(const OnlyIn&) = delete;

private:
  vtkOpenGLState::ScopedglEnableDisable isOn_;
  vtkOpenGLState::ScopedglScissor box_;
};

} // namespace espalier
