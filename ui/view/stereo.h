#pragma once

#include "ui/view/camera.h"

#include <QImage>

#include <utility>

namespace espalier {

/// The cameras of the left and the right eye about one between them. Eyes are a thirtieth of the
/// distance to the focus apart, and what is at the focus is at the depth of the screen.
[[nodiscard]] std::pair<Camera, Camera> eyesOf(const Camera& between);

/// One picture for glasses with a red glass before the left eye and a cyan one before the right:
/// the red of the left picture, the green and blue of the right one.
/// pre: both are of one size
[[nodiscard]] QImage redCyan(const QImage& left, const QImage& right);

} // namespace espalier
