#pragma once

#include "tests/support/plants.h"
#include "ui/view/plant_view.h"

#include <QTest>
#include <gtest/gtest.h>

namespace espalier::test {

/// A view of a stick of five nodes along z, seen from the front on a light background.
class StickView : public testing::Test {
protected:
  StickView() : plant_(stick(5)) {
    view_.resize(400, 300);
    view_.setDark(false);
    view_.setSkeleton(plant_);
    view_.frameAll();
    view_.show();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
  }

  [[nodiscard]] QPointF pixelOf(const Eigen::Vector3d& place) const {
    return view_.project(place).value();
  }
  [[nodiscard]] QPointF pixelOf(NodeId id) const { return pixelOf(plant_[id].position); }

  Skeleton plant_;
  PlantView view_;
};

} // namespace espalier::test
