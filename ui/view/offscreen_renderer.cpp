#include "ui/view/offscreen_renderer.h"

#include "core/base/error.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QPainter>

#include <array>
#include <limits>
#include <utility>

namespace espalier {
namespace {

QSurfaceFormat coreFormat() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

/// The display that stands for no display at all: Mesa's surfaceless platform. None on drivers
/// without it.
EGLDisplay surfacelessDisplay() {
  const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (getDisplay == nullptr) return EGL_NO_DISPLAY;
  EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
    return EGL_NO_DISPLAY;
  return display;
}

EGLContext surfacelessContext(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return EGL_NO_CONTEXT;
  constexpr std::array<EGLint, 3> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  constexpr std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                          3,
                                          EGL_CONTEXT_MINOR_VERSION,
                                          3,
                                          EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                          EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display, wanted.data(), &config, 1, &count);
  return eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
}

} // namespace

/// Surfaceless EGL, or else a context of Qt with a surface that is never seen.
class OffscreenRenderer::Context {
public:
  Context() : display_(surfacelessDisplay()), context_(surfacelessContext(display_)) {
    if (context_ != EGL_NO_CONTEXT) return;
    qtContext_ = std::make_unique<QOpenGLContext>();
    qtContext_->setFormat(coreFormat());
    qtSurface_.setFormat(coreFormat());
    qtSurface_.create();
    if (!qtContext_->create() || !qtContext_->makeCurrent(&qtSurface_))
      throw Error("OpenGL: no context to draw in; install a graphics driver or Mesa's "
                  "libgl1-mesa-dri and libegl1");
  }
  ~Context() {
    if (context_ == EGL_NO_CONTEXT || isLost_) return; // it went with its display
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_); // the display is shared: others may draw on it
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Returns whether it is: none that was lost, as by a driver that was reset, ever is again.
  bool makeCurrent() {
    if (isLost_) return false;
    if (qtContext_) {
      isLost_ = !qtContext_->makeCurrent(&qtSurface_);
      return !isLost_;
    }
    // Qt's context may be GLX, and of GLX and EGL only one can be current.
    if (QOpenGLContext* other = QOpenGLContext::currentContext()) other->doneCurrent();
    isLost_ = eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE;
    return !isLost_;
  }
  /// Leaves none current: Qt does not know of ours, and would think its own still is.
  void doneCurrent() {
    if (qtContext_)
      qtContext_->doneCurrent();
    else
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  [[nodiscard]] bool isCurrent() const {
    if (isLost_) return false;
    return qtContext_ ? QOpenGLContext::currentContext() == qtContext_.get()
                      : eglGetCurrentContext() == context_;
  }

  /// That of the other renderers, if there are any and it was not lost.
  static std::shared_ptr<Context> shared() {
    static std::weak_ptr<Context> living;
    std::shared_ptr<Context> context = living.lock();
    const bool isUsable = context && context->makeCurrent();
    if (isUsable)
      context->doneCurrent();
    else
      living = context = std::make_shared<Context>();
    return context;
  }

private:
  EGLDisplay display_;
  EGLContext context_;
  bool isLost_ = false;
  std::unique_ptr<QOpenGLContext> qtContext_;
  QOffscreenSurface qtSurface_;
};

OffscreenRenderer::OffscreenRenderer(Scene& scene, std::shared_ptr<SceneBuffers> buffers)
    : scene_(scene), buffers_(std::move(buffers)) {
  begin();
}

void OffscreenRenderer::begin() {
  renderer_.reset(); // before its context
  context_ = Context::shared();
  renderer_ = std::make_unique<PlantRenderer>(
      scene_, buffers_,
      PlantRenderer::Context{[context = context_.get()] { context->makeCurrent(); },
                             [context = context_.get()] { return context->isCurrent(); }});
}

OffscreenRenderer::~OffscreenRenderer() {
  renderer_.reset();
  context_->doneCurrent();
}

PlantRenderer::Result OffscreenRenderer::draw(const PlantRenderer::Frame& frame) {
  if (!context_->makeCurrent()) {
    begin();
    context_->makeCurrent();
  }
  return renderer_->draw(frame);
}

QImage OffscreenRenderer::image() {
  context_->makeCurrent();
  QImage image = renderer_->image();
  context_->doneCurrent();
  return image;
}

QImage OffscreenRenderer::picture(const Camera& camera, const Overlay& overlay, const QSize& size,
                                  double pixelRatio) {
  PlantRenderer::Frame frame{.camera = camera, .size = size, .pixelRatio = pixelRatio};
  frame.points = std::numeric_limits<Eigen::Index>::max();
  frame.divider = overlay.divider;
  while (!draw(frame).complete) { // points, then their relief
  }
  QImage drawn = image();
  QPainter painter(&drawn);
  painter.scale(pixelRatio, pixelRatio);
  overlay.paint(painter, scene_, camera, QSizeF(size) / pixelRatio);
  return drawn;
}

} // namespace espalier
