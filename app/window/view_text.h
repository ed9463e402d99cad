#pragma once

#include "ui/view/camera.h"

#include <QMap>
#include <QString>

#include <string>

namespace espalier {

/// How a plant is looked at, as a project keeps it.
struct ViewText {
  Camera camera;
  QMap<QString, bool> layers;     // by the id of its action: whether it is shown
  QMap<QString, QString> choices; // "color" and "point_size": the id of the action chosen
};

/// As JSON: {"camera": {"focus": [x, y, z], ...}, "layers": {"points": true, ...}, ...}.
[[nodiscard]] std::string textOf(const ViewText& view);

/// @throws Error if it is none, or its camera cannot be: every number must be finite, the distance
///         positive, the pitch between straight down and straight up
[[nodiscard]] ViewText viewFrom(const std::string& text);

} // namespace espalier
