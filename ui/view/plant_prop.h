#pragma once

#include "ui/view/plant_renderer.h"
#include "ui/view/point_pass.h"
#include "ui/view/shade_pass.h"
#include "ui/view/skeleton_pass.h"

#include <vtkProp.h>

#include <array>
#include <memory>

namespace espalier {

/// The scene as one thing that VTK draws: points, then the relief, then the
/// reference and the skeleton.
// VTK counts references. NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor)
class PlantProp final : public vtkProp {
public:
  static PlantProp* New();
  PlantProp(const PlantProp&) = delete;
  PlantProp& operator=(const PlantProp&) = delete;

  /// To be called once; `scene` must outlive the prop.
  void show(Scene& scene, std::shared_ptr<SceneBuffers> buffers);
  void setFrame(const PlantRenderer::Frame& frame) { frame_ = frame; }
  [[nodiscard]] PlantRenderer::Result result() const { return result_; }

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  PlantProp() = default;
  ~PlantProp() override;

  [[nodiscard]] DrawSettings settings(vtkViewport* viewport) const;

  void leaveBuffers(bool isCurrent);

  Scene* scene_ = nullptr;
  std::shared_ptr<SceneBuffers> buffers_;
  bool hasJoined_ = false; // the buffers
  std::unique_ptr<PointPass> points_;
  ShadePass shade_;
  std::unique_ptr<SkeletonPass> reference_;
  std::unique_ptr<SkeletonPass> skeleton_;
  std::array<std::unique_ptr<SkeletonPass>, 2> others_;
  PlantRenderer::Frame frame_;
  PlantRenderer::Result result_{};
  bool wasRelief_ = false;
};

} // namespace espalier
