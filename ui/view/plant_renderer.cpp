#include "ui/view/plant_renderer.h"

#include "core/base/error.h"
#include "ui/view/palette.h"
#include "ui/view/point_pass.h"
#include "ui/view/scene_buffers.h"
#include "ui/view/shade_pass.h"
#include "ui/view/skeleton_pass.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>

#include <utility>

namespace espalier {
namespace {

/// The state and the shaders of a context that VTK did not make.
// VTK counts references. NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor)
class GuestRenderWindow final : public vtkGenericOpenGLRenderWindow {
public:
  static GuestRenderWindow* New();
  GuestRenderWindow(const GuestRenderWindow&) = delete;
  GuestRenderWindow& operator=(const GuestRenderWindow&) = delete;

protected:
  GuestRenderWindow() = default;
  ~GuestRenderWindow() override = default;

  void OpenGLInitContext() override {
    if (this->Initialized) return;
    // A GLEW built for GLX loads all entry points, then fails for want of an X display; on EGL,
    // so on Wayland and without a screen, that failure means nothing.
    glewExperimental = GL_TRUE;
    glewInit();
    this->ContextCreationTime.Modified();
    this->GlewInitValid = GLEW_VERSION_3_3 != 0;
    this->Initialized = true;
  }
};

vtkStandardNewMacro(GuestRenderWindow);

} // namespace

struct PlantRenderer::Parts {
  Parts(Scene& plant, std::shared_ptr<SceneBuffers> with, Context in);

  [[nodiscard]] DrawSettings settings(const Frame& frame) const;
  Result drawPlant(const Frame& frame); // into the canvas
  // The points and what is behind them:
  Result drawSample(const DrawSettings& drawn, Eigen::Index atMost);
  Result drawPicture(const DrawSettings& drawn, Eigen::Index atMost);
  void release(bool isCurrent);

  Context context;
  vtkNew<GuestRenderWindow> window;
  vtkNew<vtkCallbackCommand> onMakeCurrent;
  vtkNew<vtkCallbackCommand> onIsCurrent;
  Scene& scene;
  std::shared_ptr<SceneBuffers> buffers;
  bool hasJoined = false; // the buffers
  PointPass points;
  ShadePass shade;
  std::array<SkeletonPass, 4> skeletons; // from the back to the front
  GlPicture relief;                      // the points with it, as long as they stay as they are
  bool hasRelief = false;
  GlPicture canvas;
};

std::shared_ptr<SceneBuffers> makeSceneBuffers() {
  return std::make_shared<SceneBuffers>();
}

std::size_t bytesIn(SceneBuffers& buffers) {
  return buffers.bytes();
}

PlantRenderer::Parts::Parts(Scene& plant, std::shared_ptr<SceneBuffers> with, Context in)
    : context(std::move(in)), scene(plant), buffers(std::move(with)),
      points(scene, *buffers), skeletons{
                                   SkeletonPass(scene, *buffers, SkeletonPass::What::reference),
                                   SkeletonPass(scene, *buffers, SkeletonPass::What::skeleton),
                                   SkeletonPass(scene, *buffers, Side::left),
                                   SkeletonPass(scene, *buffers, Side::right)} {
  onMakeCurrent->SetClientData(this);
  onMakeCurrent->SetCallback([](vtkObject*, unsigned long, void* parts, void*) {
    static_cast<Parts*>(parts)->context.makeCurrent();
  });
  onIsCurrent->SetClientData(this);
  onIsCurrent->SetCallback([](vtkObject*, unsigned long, void* parts, void* answer) {
    *static_cast<bool*>(answer) = static_cast<Parts*>(parts)->context.isCurrent();
  });
  window->AddObserver(vtkCommand::WindowMakeCurrentEvent, onMakeCurrent);
  window->AddObserver(vtkCommand::WindowIsCurrentEvent, onIsCurrent);
  window->SetOwnContext(0);
}

DrawSettings PlantRenderer::Parts::settings(const Frame& frame) const {
  const Camera& camera = frame.camera;
  const double width = frame.size.width();
  const double height = frame.size.height();
  const bool perspective = camera.projection == Projection::perspective;
  const double pixelSize = camera.halfHeight() / (height / 2);
  const DepthRange depths = scene.depths(camera);
  return {.window = window,
          .toView = camera.viewMatrix(scene.origin()).cast<float>(),
          .toClip = camera.projectionMatrix(width / height, depths).cast<float>(),
          .size = Eigen::Vector2d(width, height).cast<float>(),
          .pixelRatio = static_cast<float>(frame.pixelRatio),
          .perspective = perspective,
          .pixelSize = static_cast<float>(perspective ? pixelSize / camera.distance : pixelSize),
          .clip = scene.clipVolume(camera),
          .depthFade = static_cast<float>(scene.depthFade),
          .focus = scene.focusDepths(camera).forShaders(),
          .divider = frame.divider};
}

PlantRenderer::Result PlantRenderer::Parts::drawPlant(const Frame& frame) {
  if (!std::exchange(hasJoined, true)) buffers->join();
  const DrawSettings drawn = settings(frame);
  vtkOpenGLState& state = *window->GetState();
  canvas.resize(frame.size.width(), frame.size.height(), true);
  const Onto onCanvas(state, canvas.framebuffer());
  state.vtkglViewport(0, 0, canvas.width(), canvas.height());
  for (const GLenum test : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE})
    state.vtkglDisable(test);
  state.vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state.vtkglDepthMask(GL_TRUE);
  const Result result =
      frame.moving ? drawSample(drawn, frame.points) : drawPicture(drawn, frame.points);
  if (!scene.showRadii) state.vtkglClear(GL_DEPTH_BUFFER_BIT); // points hide nothing
  for (SkeletonPass& skeleton : skeletons)
    skeleton.draw(drawn);
  return result;
}

PlantRenderer::Result PlantRenderer::Parts::drawSample(const DrawSettings& drawn,
                                                       Eigen::Index atMost) {
  hasRelief = false;
  window->GetState()->vtkglClear(GL_DEPTH_BUFFER_BIT);
  shade.drawBackground(drawn, palette(scene.dark));
  return {.complete = false, .pointsDrawn = points.drawSample(drawn, atMost), .reliefDrawn = false};
}

PlantRenderer::Result PlantRenderer::Parts::drawPicture(const DrawSettings& drawn,
                                                        Eigen::Index atMost) {
  vtkOpenGLState& state = *window->GetState();
  const Palette colors = palette(scene.dark);
  const PointPass::Result result = points.draw(drawn, atMost);
  // Relief is worth its time for a picture that stays; it stays while the skeleton is edited. It
  // has a frame of its own: neither waits for both.
  const bool withRelief = result.complete && !result.changed;
  const bool isNew = !std::exchange(hasRelief, withRelief) && withRelief;
  if (isNew) {
    relief.resize(canvas.width(), canvas.height(), false);
    const Onto onRelief(state, relief.framebuffer());
    shade.draw(drawn, points.picture(), colors, true);
  }
  shade.draw(drawn, withRelief ? relief : points.picture(), colors, false);
  if (scene.showRadii) points.picture().copyTo(state, canvas.framebuffer(), GL_DEPTH_BUFFER_BIT);
  return {.complete = withRelief, .pointsDrawn = result.drawn, .reliefDrawn = isNew};
}

void PlantRenderer::Parts::release(bool isCurrent) {
  if (isCurrent) {
    points.release();
    shade.release();
    for (SkeletonPass& skeleton : skeletons)
      skeleton.release();
    relief.release();
    canvas.release();
    window->Finalize();
  }
  if (hasJoined) buffers->leave(isCurrent);
}

PlantRenderer::PlantRenderer(Scene& scene, std::shared_ptr<SceneBuffers> buffers, Context context)
    : parts_(std::make_unique<Parts>(scene, std::move(buffers), std::move(context))) {}

PlantRenderer::~PlantRenderer() {
  parts_->context.makeCurrent();
  parts_->release(parts_->context.isCurrent());
}
PlantRenderer::Result PlantRenderer::draw(const Frame& frame) {
  Parts& p = *parts_;
  p.window->OpenGLInit();
  if (GLEW_VERSION_3_3 == 0)
    throw Error("OpenGL: version 3.3 is needed; update the graphics driver or install Mesa");
  vtkOpenGLState* state = p.window->GetState();
  state->Reset(); // Qt has drawn since, behind VTK's back
  state->Push();
  const Result result = p.drawPlant(frame);
  glFinish(); // so that who measures the time of a frame measures its drawing
  state->Pop();
  p.window->GetShaderCache()->ReleaseCurrentShader(); // who draws next may use another
  return result;
}

void PlantRenderer::copyTo(unsigned int framebuffer) {
  vtkOpenGLState* state = parts_->window->GetState();
  state->ResetFramebufferBindings();
  parts_->canvas.copyTo(*state, framebuffer, GL_COLOR_BUFFER_BIT);
}

QImage PlantRenderer::image() {
  const GlPicture& canvas = parts_->canvas;
  QImage image(canvas.width(), canvas.height(), QImage::Format_RGB32);
  const Onto canvasAlone(*parts_->window->GetState(), canvas.framebuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, image.width(), image.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
               image.bits());
  return image.mirrored(); // OpenGL counts rows from below
}

} // namespace espalier
