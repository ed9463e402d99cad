#include "app/window/frame/icon.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

#include <utility>

namespace espalier {
namespace {

QColor colorFor(QIcon::Mode mode) {
  const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
  return QApplication::palette().color(group, QPalette::ButtonText);
}

class LineIcon final : public QIconEngine {
public:
  explicit LineIcon(QByteArray drawing) : drawing_(std::move(drawing)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    QByteArray colored = drawing_;
    colored.replace("#000", colorFor(mode).name().toLatin1());
    painter->setOpacity(colorFor(mode).alphaF());
    QSvgRenderer(colored).render(painter, rect);
    painter->setOpacity(1);
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap result(size);
    result.fill(Qt::transparent);
    QPainter painter(&result);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return result;
  }
  [[nodiscard]] QIconEngine* clone() const override { return new LineIcon(drawing_); }

private:
  QByteArray drawing_; // SVG with black lines
};

} // namespace

QIcon themedIcon(const QString& name) {
  QFile file(":/icons/" + name + ".svg");
  const bool isThere = file.open(QIODevice::ReadOnly);
  Q_ASSERT(isThere);
  return isThere ? QIcon(new LineIcon(file.readAll())) : QIcon();
}

QIcon programIcon() {
  return QIcon(QStringLiteral(":/icons/espalier.svg"));
}

} // namespace espalier
