#pragma once

#include "ui/view/overlay.h"

#include <QWidget>

#include <functional>
#include <utility>

namespace espalier {

/// Lies over the surface and is transparent, so that hovers and edits need not paint it again.
class OverlayWidget : public QWidget {
public:
  OverlayWidget(std::function<void(QPainter&)> paint, QWidget* parent)
      : QWidget(parent), paint_(std::move(paint)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }

protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    paint_(painter);
  }

private:
  std::function<void(QPainter&)> paint_;
};

} // namespace espalier
