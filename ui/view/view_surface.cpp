#include "ui/view/view_surface.h"

#include "core/base/error.h"
#include "ui/view/offscreen_renderer.h"
#include "ui/view/stereo.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace espalier {
namespace {

QSize devicePixels(const QWidget& widget) {
  return (QSizeF(widget.size()) * widget.devicePixelRatioF()).toSize().expandedTo({1, 1});
}

/// Draws a frame and notifies the client how long it took.
/// @param second  draws for the right eye, and is there only while that is asked for
/// @return the picture for both eyes; none: it is what the renderer has drawn
template <class Renderer, class Make>
std::optional<QImage> drawFrame(Renderer& renderer, std::unique_ptr<Renderer>& second,
                                const Make& makeSecond, const SurfaceClient& client,
                                const QWidget& widget) {
  PlantRenderer::Frame frame = client.nextFrame(devicePixels(widget), widget.devicePixelRatioF());
  QElapsedTimer timer;
  timer.start();
  std::optional<QImage> both;
  PlantRenderer::Result result{};
  if (client.isStereo()) {
    if (!second) second = makeSecond();
    const auto [left, right] = eyesOf(frame.camera);
    frame.points = std::max<Eigen::Index>(1, frame.points / 2);
    frame.camera = left;
    result = renderer.draw(frame);
    const QImage ofLeft = renderer.image();
    frame.camera = right;
    const PlantRenderer::Result other = second->draw(frame);
    both = redCyan(ofLeft, second->image());
    result.complete = result.complete && other.complete;
    result.pointsDrawn += other.pointsDrawn;
    result.reliefDrawn = result.reliefDrawn || other.reliefDrawn;
  } else {
    second.reset();
    result = renderer.draw(frame);
  }
  client.drawn(result, static_cast<double>(timer.nsecsElapsed()) * 1e-6);
  return both;
}

void paintImage(QPainter& painter, QImage image, double pixelRatio) {
  image.setDevicePixelRatio(pixelRatio);
  painter.drawImage(0, 0, image);
}

/// An error has no caller to go to from within a paint event: it is shown where the plant would be.
void paintError(QPainter& painter, const QWidget& widget, const Error& error) {
  painter.fillRect(widget.rect(), widget.palette().window());
  painter.setPen(widget.palette().windowText().color());
  painter.drawText(widget.rect().marginsRemoved({24, 24, 24, 24}),
                   Qt::AlignCenter | Qt::TextWordWrap, QString::fromUtf8(error.what()));
}

class ImageSurface : public QWidget {
public:
  ImageSurface(Scene& scene, std::shared_ptr<SceneBuffers> buffers, SurfaceClient client,
               QWidget* parent)
      : QWidget(parent), scene_(scene), buffers_(std::move(buffers)), client_(std::move(client)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
  }

protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    try {
      const auto make = [this] { return std::make_unique<OffscreenRenderer>(scene_, buffers_); };
      if (!renderer_) renderer_ = make();
      const auto both = drawFrame(*renderer_, second_, make, client_, *this);
      paintImage(painter, both ? *both : renderer_->image(), devicePixelRatioF());
    } catch (const Error& error) {
      paintError(painter, *this, error);
    }
  }

private:
  Scene& scene_;
  std::shared_ptr<SceneBuffers> buffers_;
  SurfaceClient client_;
  std::unique_ptr<OffscreenRenderer> renderer_;
  std::unique_ptr<OffscreenRenderer> second_; // for the right eye, if there are two
};

class OpenGlSurface : public QOpenGLWidget {
public:
  OpenGlSurface(Scene& scene, std::shared_ptr<SceneBuffers> buffers, SurfaceClient client,
                QWidget* parent)
      : QOpenGLWidget(parent), scene_(scene), buffers_(std::move(buffers)),
        client_(std::move(client)) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(0);
    setFormat(format);
  }
  ~OpenGlSurface() override { release(); }
  OpenGlSurface(const OpenGlSurface&) = delete;
  OpenGlSurface& operator=(const OpenGlSurface&) = delete;

protected:
  void initializeGL() override {
    // Comes again with another context, after the first has gone, when the widget changes windows.
    // QOpenGLWidget::makeCurrent would also bind its framebuffer, in the midst of VTK's drawing.
    surface_ = context()->surface();
    lost_ = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
    renderer_ = makeRenderer();
  }

  void paintGL() override {
    try {
      const auto both = drawFrame(
          *renderer_, second_, [this] { return makeRenderer(); }, client_, *this);
      if (!both) return renderer_->copyTo(defaultFramebufferObject());
      QPainter painter(this);
      paintImage(painter, *both, devicePixelRatioF());
    } catch (const Error& error) {
      QPainter painter(this);
      paintError(painter, *this, error);
    }
  }

private:
  std::unique_ptr<PlantRenderer> makeRenderer() {
    return std::make_unique<PlantRenderer>(
        scene_, buffers_,
        PlantRenderer::Context{
            [this] {
              if (context() && QOpenGLContext::currentContext() != context())
                context()->makeCurrent(surface_);
            },
            [this] { return context() && QOpenGLContext::currentContext() == context(); }});
  }

  void release() {
    disconnect(lost_);
    if (!renderer_) return;
    makeCurrent();
    second_.reset();
    renderer_.reset();
    doneCurrent();
  }

  Scene& scene_;
  std::shared_ptr<SceneBuffers> buffers_;
  SurfaceClient client_;
  QSurface* surface_ = nullptr;
  QMetaObject::Connection lost_;
  std::unique_ptr<PlantRenderer> renderer_;
  std::unique_ptr<PlantRenderer> second_; // for the right eye, if there are two
};

/// Whether the processor does what a graphics card should, as in virtual machines and over a
/// network.
bool drawnBySoftware() {
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface)) return true;
  const auto* text = context.functions()->glGetString(GL_RENDERER);
  const QByteArray renderer = text == nullptr ? "" : reinterpret_cast<const char*>(text);
  return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "swrast", "Software", "GDI"},
                             [&](const char* name) { return renderer.contains(name); });
}

} // namespace

SurfaceKind surfaceKind() {
  const QByteArray wanted = qgetenv("ESPALIER_SURFACE").toLower();
  if (wanted == "image") return SurfaceKind::image;
  if (wanted == "opengl") return SurfaceKind::openGl;
  const QString platform = QGuiApplication::platformName();
  // On these Qt crashes when a QOpenGLWidget is shown.
  for (const char* without : {"offscreen", "minimal", "vnc"})
    if (platform == QLatin1String(without)) return SurfaceKind::image;
  static const bool software = drawnBySoftware();
  return software ? SurfaceKind::image : SurfaceKind::openGl;
}

QWidget* makeSurface(Scene& scene, std::shared_ptr<SceneBuffers> buffers, SurfaceClient client,
                     QWidget* parent) {
  if (surfaceKind() == SurfaceKind::image)
    return new ImageSurface(scene, std::move(buffers), std::move(client), parent);
  return new OpenGlSurface(scene, std::move(buffers), std::move(client), parent);
}

} // namespace espalier
