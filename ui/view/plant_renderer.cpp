#include "ui/view/plant_renderer.h"

#include "core/base/error.h"
#include "ui/view/plant_prop.h"
#include "ui/view/scene_buffers.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCullerCollection.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <utility>

namespace espalier {
namespace {

/// A render window in a context that it did not make.
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
  Context context;
  vtkNew<GuestRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<PlantProp> plant;
  vtkNew<vtkCallbackCommand> onMakeCurrent;
  vtkNew<vtkCallbackCommand> onIsCurrent;
};

std::shared_ptr<SceneBuffers> makeSceneBuffers() {
  return std::make_shared<SceneBuffers>();
}

std::size_t bytesIn(SceneBuffers& buffers) {
  return buffers.bytes();
}

PlantRenderer::PlantRenderer(Scene& scene, std::shared_ptr<SceneBuffers> buffers, Context context)
    : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.context = std::move(context);
  p.onMakeCurrent->SetClientData(&p);
  p.onMakeCurrent->SetCallback([](vtkObject*, unsigned long, void* parts, void*) {
    static_cast<Parts*>(parts)->context.makeCurrent();
  });
  p.onIsCurrent->SetClientData(&p);
  p.onIsCurrent->SetCallback([](vtkObject*, unsigned long, void* parts, void* answer) {
    *static_cast<bool*>(answer) = static_cast<Parts*>(parts)->context.isCurrent();
  });
  p.window->AddObserver(vtkCommand::WindowMakeCurrentEvent, p.onMakeCurrent);
  p.window->AddObserver(vtkCommand::WindowIsCurrentEvent, p.onIsCurrent);
  p.window->SetOwnContext(0);
  p.window->SetMultiSamples(0);
  p.window->SetFrameBlitModeToNoBlit();
  p.window->AddRenderer(p.renderer);
  p.renderer->GetCullers()->RemoveAllItems();
  p.renderer->SetActiveCamera(vtkNew<vtkCamera>()); // not used: else VTK makes and aims one
  p.plant->show(scene, std::move(buffers));
  p.renderer->AddViewProp(p.plant);
}

PlantRenderer::~PlantRenderer() {
  parts_->context.makeCurrent();
  if (parts_->context.isCurrent()) parts_->window->Finalize();
}

PlantRenderer::Result PlantRenderer::draw(const Frame& frame) {
  Parts& p = *parts_;
  p.window->SetSize(frame.size.width(), frame.size.height());
  p.plant->setFrame(frame);
  p.window->OpenGLInit();
  if (GLEW_VERSION_3_3 == 0)
    throw Error("OpenGL: version 3.3 is needed; update the graphics driver or install Mesa");
  vtkOpenGLState* state = p.window->GetState();
  state->Reset(); // Qt has drawn since, behind VTK's back
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);
  p.window->Render();
  glFinish(); // so that who measures the time of a frame measures its drawing
  state->Pop();
  p.window->GetShaderCache()->ReleaseCurrentShader(); // who draws next may use another
  return p.plant->result();
}

void PlantRenderer::copyTo(unsigned int framebuffer) {
  Parts& p = *parts_;
  const int* size = p.window->GetSize();
  vtkOpenGLState* state = p.window->GetState();
  state->ResetFramebufferBindings();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  p.window->BlitDisplayFramebuffer(0, 0, 0, size[0], size[1], 0, 0, size[0], size[1],
                                   GL_COLOR_BUFFER_BIT, GL_NEAREST);
  state->PopFramebufferBindings();
}

QImage PlantRenderer::image() {
  Parts& p = *parts_;
  const int* size = p.window->GetSize();
  QImage image(size[0], size[1], QImage::Format_RGB32);
  vtkOpenGLState* state = p.window->GetState();
  state->PushFramebufferBindings();
  p.window->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  p.window->GetDisplayFramebuffer()->ActivateReadBuffer(0);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size[0], size[1], GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, image.bits());
  state->PopFramebufferBindings();
  return image.mirrored(); // OpenGL counts rows from below
}

} // namespace espalier
