#pragma once

#include "ui/view/clip_handles.h"
#include "ui/view/color_bar.h"
#include "ui/view/detail_budget.h"
#include "ui/view/divider.h"
#include "ui/view/known_views.h"
#include "ui/view/minimap.h"
#include "ui/view/navigator.h"
#include "ui/view/overlay_widget.h"
#include "ui/view/plant_view.h"
#include "ui/view/pointer_input.h"
#include "ui/view/scene.h"
#include "ui/view/touch_input.h"
#include "ui/view/view_surface.h"

#include <QPoint>
#include <QTimer>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace espalier {

/// What views of one plant have together: what they show, on the graphics card once.
struct PlantView::Shared {
  Scene scene;
  std::shared_ptr<SceneBuffers> buffers = makeSceneBuffers();
  QString unit; // of lengths; empty: not known
  std::vector<ShownHull> hulls;
  std::optional<ShownEnvelope> envelope;
  std::optional<ShownAttachment> attachment;
  std::vector<ShownGhost> ghosts;
  std::optional<Eigen::Vector3d> rootMark; // as PlantView::setRootMark
  KnownViews knownViews;
  bool doColorsSpanSeen = true; // as PlantView::setColorsSpanSeen
  bool isStereo = false;        // as PlantView::setStereo
  std::vector<Parts*> views;

  [[nodiscard]] SeenSides seenSides() const; // in any view
};

/// What a view is made of; for its own sources.
struct PlantView::Parts {
  Parts(PlantView& widget, std::shared_ptr<Shared> with)
      : owner(widget), shared(std::move(with)), scene(shared->scene),
        pointer(scene, navigator, divider),
        surface(makeSurface(scene, shared->buffers, client(), &widget)),
        overlayWidget(
            new OverlayWidget([this](QPainter& painter) { paintOverlay(painter); }, &widget)) {
    shared->views.push_back(this);
  }
  ~Parts() { std::erase(shared->views, this); }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  SurfaceClient client();
  void setUpOverlay();
  void paintOverlay(QPainter& painter);
  [[nodiscard]] Overlay overlayOfPicture() const;
  void giveWay(); // has legends and the minimap leave the plant, once nothing moves
  // In all views of the plant; where one moves its camera, that view alone.
  void redrawSkeleton() {
    for (Parts* each : shared->views)
      each->redrawSurface();
    for (Parts* each : shared->views)
      if (each->minimap != nullptr) each->minimap->noteChange();
  }
  void redraw() {
    for (Parts* each : shared->views)
      each->redrawThis();
    redrawSkeleton();
  }
  void redrawSurface() {
    complete = false;
    surface->update();
    settling.start();
  }
  void redrawThis() {
    mayBeInTheWay = true;
    redrawSurface();
    overlayWidget->update();
    refreshColorBars();
    refreshMinimap();
    refreshDivider();
  }
  [[nodiscard]] bool isFirst() const { return shared->views.front() == this; }
  /// How many share the time there is to draw.
  [[nodiscard]] double seenViews() const;
  void refreshColorBars(); // plant_view_looks.cpp
  void spanSeen();         // likewise: has the colors of the points span what is seen
  void refreshMinimap();   // likewise
  void refreshDivider();
  /// Another scene as this view would draw it, without legends and names.
  [[nodiscard]] QImage bare(const Scene& other, const QSize& size,
                            Framing framing) const; // plant_view_states.cpp
  ColorBar* makeColorBar();
  Minimap* makeMinimap();
  [[nodiscard]] ColorBar* draggedColorBar() const;
  [[nodiscard]] ClipHandles::Sight sight() const {
    return {scene.clip, scene.bounds(), pointer.screen()};
  }
  void hoverClip(std::optional<ClipHandles::Handle> handle); // plant_view_clip.cpp
  // plant_view_envelope.cpp
  void hoverEnvelope(std::optional<std::size_t> handle);
  void giveBackEnvelope(); // what is dragged goes back to where it was
  // plant_view_touch.cpp
  bool takeTouch(QTouchEvent& event);
  void click(const TouchInput::Tap& tap);
  /// How long drawing may take, but for so many points at least.
  struct Pace {
    double frame; // [ms]
    Eigen::Index fewest;
  };
  static constexpr Pace turning{30, 20'000};        // 25 a second with what Qt adds
  static constexpr Pace completing{12, 10'000};     // the hand may come back at any moment
  static constexpr Pace besidePreviews{10, 10'000}; // a job runs, and its result is news to others

  /// Something else follows in a moment upon what is drawn now.
  void unsettle(const Pace& until) {
    moving = true;
    complete = false;
    pace = until;
    rest.start();
  }
  void moved() {
    unsettle(turning);
    redrawThis();
    emit owner.cameraMoved(navigator.camera());
  }
  /// The same camera for a plant that stands as this one: who keeps cameras need not know how.
  [[nodiscard]] Camera upright(Camera camera) const {
    camera.upAxis = scene.up;
    return camera;
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
  std::shared_ptr<Shared> shared;
  Scene& scene; // of `shared`
  Navigator navigator;
  PointerInput pointer;
  QPoint pointerAt{-1, -1}; // on the screen, when it was noted last
  TouchInput touch{navigator, pointer};
  Overlay overlay;
  ClipHandles clipHandles;
  EnvelopeHandles envelopeHandles;
  DetailBudget sampleBudget; // a still picture, put together from steps, costs more
  DetailBudget pictureBudget;
  [[nodiscard]] DetailBudget& budget() { return moving ? sampleBudget : pictureBudget; }
  QTimer settling;     // runs while anything changes, and a moment longer
  QTimer rest;         // runs while the camera, or what is shown, changes
  bool moving = false; // likewise
  Pace pace = turning; // while it runs
  bool complete = false;
  int framesAtRest = 0; // as PlantView::framesAtRest
  bool wasFramed = false;
  bool mayBeInTheWay = true; // the camera, or what is shown, has changed since giveWay()
  QWidget* surface;          // owned by the view; goes before what it draws, see ~PlantView
  QWidget* overlayWidget;
  double divider = 1;               // as PlantView::setDivider
  Divider* dividerHandle = nullptr; // owned by the view; null: not shown yet
  Minimap* minimap = nullptr;       // owned by the view; null: switched off
  std::vector<ColorBar*> colorBars; // owned by the view; those beyond the legends are hidden
};

} // namespace espalier
