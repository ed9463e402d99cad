#pragma once

#include "ui/view/plant_view.h"

#include <vector>

namespace espalier {

/// The view that the pointer is in, as the canvas of the tools. What they preview is shown in all
/// views: it has its place in the plant.
class ActiveCanvas : public Canvas {
public:
  explicit ActiveCanvas(PlantView& first) : views_{&first}, active_(&first) {}

  void add(PlantView& view) { views_.push_back(&view); }
  void remove(const PlantView& view) {
    std::erase(views_, &view);
    if (active_ == &view) active_ = views_.front();
  }
  /// pre: it is one of the views
  void activate(PlantView& view) {
    if (active_ != &view) active_->showBand({});
    active_ = &view;
  }
  [[nodiscard]] PlantView& view() const { return *active_; }
  [[nodiscard]] const std::vector<PlantView*>& views() const { return views_; }

  [[nodiscard]] std::vector<NodeId> nodesInside(const QPolygonF& area, Depth depth) const override {
    return active_->nodesInside(area, depth);
  }
  [[nodiscard]] std::vector<Eigen::Index> pointsInside(const QPolygonF& area,
                                                       Depth depth) const override {
    return active_->pointsInside(area, depth);
  }
  [[nodiscard]] std::optional<QPointF> project(const Eigen::Vector3d& place) const override {
    return active_->project(place);
  }
  void showBand(const QPolygonF& band) override { active_->showBand(band); }
  void showPreview(const Preview& preview) override {
    for (PlantView* view : views_)
      view->showPreview(preview);
  }

private:
  std::vector<PlantView*> views_;
  PlantView* active_;
};

} // namespace espalier
