#pragma once

#include "ui/view/clip_handles.h"
#include "ui/view/color_bar.h"
#include "ui/view/detail_budget.h"
#include "ui/view/navigator.h"
#include "ui/view/overlay_widget.h"
#include "ui/view/plant_view.h"
#include "ui/view/pointer_input.h"
#include "ui/view/scene.h"
#include "ui/view/view_surface.h"

#include <QTimer>

#include <algorithm>
#include <vector>

namespace espalier {

/// What a view is made of; for its own sources.
struct PlantView::Parts {
  explicit Parts(PlantView& widget)
      : owner(widget), pointer(scene, navigator), surface(makeSurface(scene, client(), &widget)),
        overlayWidget(
            new OverlayWidget([this](QPainter& painter) { paintOverlay(painter); }, &widget)) {}

  SurfaceClient client();
  void paintOverlay(QPainter& painter);
  void redrawSkeleton() {
    complete = false;
    surface->update();
  }
  void redraw() {
    redrawSkeleton();
    overlayWidget->update();
    refreshColorBars();
  }
  void refreshColorBars(); // plant_view_looks.cpp
  ColorBar* makeColorBar();
  [[nodiscard]] ColorBar* draggedColorBar() const;
  [[nodiscard]] ClipHandles::Sight sight() const {
    return {scene.clip, scene.bounds(), pointer.screen()};
  }
  void hoverClip(std::optional<ClipHandles::Handle> handle); // plant_view_clip.cpp
  void moved() {
    moving = true;
    rest.start();
    redraw();
  }
  void moveTo(const Camera& camera, bool seen) {
    if (seen && wasFramed)
      navigator.flyTo(camera);
    else
      navigator.set(camera);
  }

  /// @param what a box, or places
  template <class What> void frame(const What& what, const PlantView& view) {
    Camera camera = navigator.destination();
    camera.frame(what, view.width() / std::max(1.0, double(view.height())));
    moveTo(camera, view.isVisible());
    wasFramed = true;
  }

  PlantView& owner;
  Scene scene;
  Navigator navigator;
  PointerInput pointer;
  Overlay overlay;
  ClipHandles clipHandles;
  DetailBudget budget;
  QTimer rest; // runs while the camera moves
  bool moving = false;
  bool complete = false;
  bool wasFramed = false;
  QWidget* surface; // owned by the view; goes before what it draws, see ~PlantView
  QWidget* overlayWidget;
  std::vector<ColorBar*> colorBars; // owned by the view; those beyond the legends are hidden
};

} // namespace espalier
