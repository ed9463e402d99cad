#include "tests/support/fake_spacenavd.h"
#include "tests/support/plants.h"
#include "ui/view/plant_view.h"
#include "ui/view/space_mouse.h"

#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace espalier {
namespace {

class SpaceMouseTest : public testing::Test {
protected:
  SpaceMouseTest() {
    QObject::connect(&mouse_, &SpaceMouse::steered,
                     [this](const Steering& by) { steered_.push_back(by); });
    QObject::connect(&mouse_, &SpaceMouse::pressed,
                     [this](int button) { pressed_.push_back(button); });
  }
  void connectToDriver() {
    driver_.emplace((folder_.path() + "/spnav.sock").toStdString());
    mouse_.connectToDriver();
    ASSERT_TRUE(mouse_.isConnected());
    driver_->accept();
  }

  QTemporaryDir folder_;
  std::optional<test::FakeSpacenavd> driver_;
  SpaceMouse mouse_;
  std::vector<Steering> steered_;
  std::vector<int> pressed_;
};

TEST_F(SpaceMouseTest, SaysHowFarTheCapIsHeldAndForHowLong) {
  connectToDriver();
  driver_->move({350, -35, 70, 175, 0, 20}, 20);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !steered_.empty(); }));
  const Eigen::Vector3d shift(0.02, -0.002, 0.004);
  EXPECT_LT((steered_.front().shift - shift).norm(), 1e-12);
  EXPECT_LT((steered_.front().turn - Eigen::Vector2d(0.01, 0)).norm(), 1e-12);
  driver_->move({0, 0, 0, 0, 0, 0}, 20); // at rest
  EXPECT_FALSE(QTest::qWaitFor([this] { return steered_.size() > 1; }, 100));
}

TEST_F(SpaceMouseTest, TakesAllThatHasComeMeanwhileAtOnce) {
  connectToDriver();
  driver_->move({100, 0, 0, 0, 0, 0}, 5000); // the first after a pause
  driver_->move({100, 0, 0, 0, 0, 0}, 10);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !steered_.empty(); }));
  ASSERT_EQ(steered_.size(), 1U);
  EXPECT_NEAR(steered_.front().shift.x(), 0.11 * 100 / 350, 1e-12);
}

TEST_F(SpaceMouseTest, SaysWhichButtonIsPressed) {
  connectToDriver();
  driver_->press(1);
  driver_->release(1);
  driver_->press(0);
  ASSERT_TRUE(QTest::qWaitFor([this] { return pressed_.size() == 2; }));
  EXPECT_EQ(pressed_, (std::vector{1, 0}));
}

TEST_F(SpaceMouseTest, FindsADriverThatIsStartedAgain) {
  mouse_.connectToDriver();
  EXPECT_FALSE(mouse_.isConnected()) << "there is none";
  connectToDriver();
  driver_.reset(); // it ends
  ASSERT_TRUE(QTest::qWaitFor([this] { return !mouse_.isConnected(); }));
  connectToDriver();
  driver_->move({0, 0, 0, 0, 35, 0}, 10);
  EXPECT_TRUE(QTest::qWaitFor([this] { return steered_.size() == 1; }));
}

class SteeringTest : public testing::Test {
protected:
  SteeringTest() : plant_(test::stick(5)) {
    view_.resize(400, 300);
    view_.setSkeleton(plant_);
    view_.frameAll();
    view_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view_));
  }
  /// Where a node is moved to on the screen, as a mouse moves the plant.
  QPointF moved(NodeId id, const Steering& by) {
    const QPointF before = pixelOf(id);
    view_.steer(by);
    return pixelOf(id) - before;
  }
  QPointF pixelOf(NodeId id) { return view_.project(plant_[id].position).value(); }
  double height() { return std::abs(pixelOf(NodeId(0)).y() - pixelOf(NodeId(4)).y()); }

  Skeleton plant_;
  PlantView view_;
};

TEST_F(SteeringTest, ShiftsThePlantWithTheCap) {
  const QPointF right = moved(NodeId(2), {.shift = {0.1, 0, 0}});
  EXPECT_GT(right.x(), 10);
  EXPECT_NEAR(right.y(), 0, 1e-6);
  EXPECT_LT(moved(NodeId(2), {.shift = {0, 0.1, 0}}).y(), -10) << "up the screen";
  const double before = height();
  view_.steer({.shift = {0, 0, 0.2}});
  EXPECT_LT(height(), before) << "pushed away it gets smaller";
}

TEST_F(SteeringTest, TurnsThePlantWithTheCapAndKeepsItUpright) {
  const Camera before = view_.camera();
  view_.steer({.turn = {0.1, 0}});
  EXPECT_GT(view_.camera().pitch, before.pitch) << "its top comes nearer";
  EXPECT_EQ(view_.camera().yaw, before.yaw);
  view_.steer({.turn = {0, 0.1}});
  EXPECT_LT(view_.camera().yaw, before.yaw) << "its front goes to the right";
  EXPECT_EQ(view_.camera().focus, before.focus);
}

TEST_F(SteeringTest, EndsAFlight) {
  view_.look(StandardView::top);
  view_.steer({.turn = {0, 0.1}});
  EXPECT_EQ(view_.camera(), view_.currentCamera());
}

} // namespace
} // namespace espalier
