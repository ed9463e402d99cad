#pragma once

#include "core/skeleton/skeleton.h"
#include "ui/view/camera.h"
#include "ui/view/clip.h"
#include "ui/view/color_map.h"

#include <QMap>
#include <QString>
#include <QStringList>

#include <map>
#include <string>
#include <vector>

namespace espalier {

/// A view to come back to.
struct SavedView {
  QString name;
  Camera camera;
  Clip clip;
  double depthFade = 0;
  std::vector<NodeId> hidden;
  bool operator==(const SavedView&) const = default;
};

/// How a plant is looked at, as a project keeps it.
struct ViewText {
  Camera camera;
  QMap<QString, bool> layers;                // by the id of its action: whether it is shown
  QMap<QString, QString> choices;            // by choiceNames(): the id of the action
  std::map<QString, ValueRange> ranges = {}; // of color bars, by the id of the legend
  Clip clip = {};
  double depthFade = 0;
  std::vector<SavedView> saved = {};
};

/// "color", "node_color", "point_size", ...: what of a view is one of several actions.
[[nodiscard]] const QStringList& choiceNames();

/// As JSON: {"camera": {"focus": [x, y, z], ...}, "layers": {"points": true, ...}, ...,
/// "ranges": {"color_height": [0, 2.5]}, "slab": [0, 1], "box": [[...], [...]],
/// "saved": [{"name": "...", "camera": {...}, "slab": [0, 1], "box": [...], "hidden": [12]}]}.
[[nodiscard]] std::string textOf(const ViewText& view);

/// @throws Error if it is none, or its camera cannot be: every number must be finite, the distance
///         positive, the pitch between straight down and straight up
[[nodiscard]] ViewText viewFrom(const std::string& text);

} // namespace espalier
