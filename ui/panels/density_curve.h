#pragma once

#include "ui/document/binned_values.h"

#include <QWidget>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// The radius of an adaptive contraction over the density of the points, with the densities of the
/// plant behind it: radius = least + (most - least) density^exponent, see densityRadii().
///
/// Its three handles are dragged, or moved by the arrow keys, finely with Shift; Tab goes from one
/// to the next, a double click back to the default.
class DensityCurve : public QWidget {
  Q_OBJECT

public:
  struct Curve {
    double least = 1; // [L], where the points lie thinnest
    double most = 1;  // [L], where they lie densest
    double exponent = 1;

    [[nodiscard]] double radiusAt(double density) const; // [L]; density in [0, 1]
    bool operator==(const Curve&) const = default;
  };

  explicit DensityCurve(QWidget* parent = nullptr);

  void setCurve(const Curve& curve);
  [[nodiscard]] const Curve& curve() const { return curve_; }
  /// @param densities normalized to [0, 1], one per point; none: no histogram
  void setDensities(const std::vector<float>& densities);
  /// Between what ends and exponents it can be set, what radii are written in, and the spacing of
  /// the points [L].
  void setLimits(const Curve& lowest, const Curve& highest, const QString& unit, double spacing);
  void setDefault(const Curve& curve);

  [[nodiscard]] QSize sizeHint() const override { return {220, 160}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {180, 140}; }

signals:
  void changed(const espalier::DensityCurve::Curve& curve); // by hand

protected:
  bool event(QEvent* event) override; // tips; its keys are no shortcuts
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool focusNextPrevChild(bool isNext) override;

private:
  enum class Handle : std::uint8_t { least, bend, most };
  static constexpr std::array handles = {Handle::least, Handle::bend, Handle::most};
  struct Drag {
    double y;     // of the handle, before it is rounded and kept within its limits [px]
    double mouse; // at its last move [px]
    Curve before;
  };

  [[nodiscard]] QRectF inner() const; // within the axes
  [[nodiscard]] QPointF placeOf(double density, double radius) const;
  [[nodiscard]] double radiusAt(double y) const; // [L]; beyond the axes, too
  [[nodiscard]] QPointF placeOf(Handle handle) const;
  [[nodiscard]] std::optional<Handle> handleAt(const QPointF& place) const;
  [[nodiscard]] QString textOf(double radius) const; // in the unit and in spacings
  [[nodiscard]] QString textOf(Handle handle) const;
  [[nodiscard]] double radiusStep() const; // [L], what a key moves a handle by

  void moveTo(Handle handle, double y, bool isFine);
  void setRadius(Handle handle, double radius);
  void setExponent(double exponent);
  void step(Handle handle, int direction, bool isFine);
  void set(const Curve& curve);
  void refreshScale();
  void describe();
  void paintDensities(QPainter& painter) const;
  void paintAxes(QPainter& painter) const;
  void paintCurve(QPainter& painter) const;
  void paintHandles(QPainter& painter) const;

  Curve curve_;
  Curve default_;
  BinnedValues densities_;
  Curve lowest_{.least = 0, .most = 0, .exponent = 0};
  Curve highest_;
  QString unit_;
  double spacing_ = 1; // [L]
  double top_ = 1;     // radius at the upper end of the axis [L]
  Handle current_ = Handle::least;
  std::optional<Handle> hovered_;
  std::optional<Drag> drag_; // of the current handle
};

} // namespace espalier
