#include "ui/view/plant_prop.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkViewport.h>

#include <utility>

namespace espalier {

vtkStandardNewMacro(PlantProp);

PlantProp::~PlantProp() {
  leaveBuffers(false);
}

void PlantProp::show(Scene& scene, std::shared_ptr<SceneBuffers> buffers) {
  scene_ = &scene;
  buffers_ = std::move(buffers);
  points_ = std::make_unique<PointPass>(scene, *buffers_);
  reference_ = std::make_unique<SkeletonPass>(scene, *buffers_, SkeletonPass::What::reference);
  skeleton_ = std::make_unique<SkeletonPass>(scene, *buffers_, SkeletonPass::What::skeleton);
  for (const Side side : {Side::left, Side::right})
    others_[static_cast<std::size_t>(side)] =
        std::make_unique<SkeletonPass>(scene, *buffers_, side);
}

void PlantProp::leaveBuffers(bool isCurrent) {
  if (std::exchange(hasJoined_, false)) buffers_->leave(isCurrent);
}

DrawSettings PlantProp::settings(vtkViewport* viewport) const {
  const Camera& camera = frame_.camera;
  const double width = frame_.size.width();
  const double height = frame_.size.height();
  const bool perspective = camera.projection == Projection::perspective;
  const double pixelSize = camera.halfHeight() / (height / 2);
  const DepthRange depths = camera.depthsOf(scene_->bounds());
  return {.window = vtkOpenGLRenderWindow::SafeDownCast(viewport->GetVTKWindow()),
          .toView = camera.viewMatrix(scene_->origin()).cast<float>(),
          .toClip = camera.projectionMatrix(width / height, depths).cast<float>(),
          .size = Eigen::Vector2d(width, height).cast<float>(),
          .pixelRatio = static_cast<float>(frame_.pixelRatio),
          .perspective = perspective,
          .pixelSize = static_cast<float>(perspective ? pixelSize / camera.distance : pixelSize),
          .clip = scene_->clipVolume(camera),
          .depthFade = static_cast<float>(scene_->depthFade),
          .divider = frame_.divider};
}

int PlantProp::RenderOpaqueGeometry(vtkViewport* viewport) {
  if (!std::exchange(hasJoined_, true)) buffers_->join();
  const DrawSettings drawn = settings(viewport);
  const PointPass::Result points = points_->draw(drawn, frame_.points, frame_.moving);
  // Relief is worth its time for a picture that stays; it stays while the skeleton is edited. It
  // has a frame of its own: neither waits for both.
  const bool relief = !frame_.moving && points.complete && !points.changed;
  const bool isShaded = points.changed || relief != wasRelief_;
  if (isShaded) shade_.shade(drawn, points_->picture(), palette(scene_->dark), relief);
  wasRelief_ = relief;
  shade_.copy(drawn, points_->picture(), scene_->showRadii);
  reference_->draw(drawn);
  skeleton_->draw(drawn);
  for (const auto& other : others_)
    other->draw(drawn);
  result_ = {.complete = relief, .pointsDrawn = points.drawn, .shaded = isShaded};
  return 1;
}

void PlantProp::ReleaseGraphicsResources(vtkWindow* window) {
  points_->release();
  shade_.release();
  reference_->release();
  skeleton_->release();
  for (const auto& other : others_)
    other->release();
  leaveBuffers(true);
  vtkProp::ReleaseGraphicsResources(window);
}

} // namespace espalier
