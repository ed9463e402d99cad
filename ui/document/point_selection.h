#pragma once

#include "core/cloud/point_set.h"

#include <QObject>

#include <utility>

namespace espalier {

/// The chosen points of the scan of a document.
class PointSelection : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  [[nodiscard]] const PointSet& points() const { return points_; }
  [[nodiscard]] bool isEmpty() const { return points_.isEmpty(); }

  void set(PointSet points) {
    if (points == points_) return;
    points_ = std::move(points);
    emit changed();
  }
  void clear() { set({}); }

signals:
  void changed();

private:
  PointSet points_;
};

} // namespace espalier
