#pragma once

#include "app/window/frame/window_part.h"
#include "core/cloud/point_set.h"
#include "ui/view/point_look.h"

#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

class PlantDocument;
class PlantView;

/// How the points of the scan look, by all that has a say in it: what the skeleton explains, what
/// is set aside, what is shown alone or hidden, and what is selected.
class PointStates : public WindowPart {
  Q_OBJECT

public:
  /// Both must outlive it.
  PointStates(PlantDocument& document, PlantView& view);

  /// Of the points that are neither set aside nor selected; null: as usual. Until another scan.
  void setExplained(std::shared_ptr<const std::vector<PointState>> states);
  void showAside(bool areShown);                // the points that are set aside
  void isolate(std::optional<PointSet> points); // hides all others; until another scan
  void hide(PointSet points);                   // these alone; until another scan
  [[nodiscard]] bool isIsolated() const { return isolated_.has_value(); }

private:
  void show();
  [[nodiscard]] std::shared_ptr<const std::vector<PointState>> states() const;

  PlantDocument& document_;
  PlantView& view_;
  std::shared_ptr<const std::vector<PointState>> explained_;
  std::optional<PointSet> isolated_;
  PointSet hidden_;
  bool isAsideShown_ = false;
  bool hasStates_ = false; // the view shows them
  QTimer timer_;           // many changes at a time are shown at once
};

} // namespace espalier
