#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "ui/view/palette.h"
#include "ui/view/plant_view.h"

#include <QHBoxLayout>
#include <QTest>
#include <gtest/gtest.h>

#include <memory>

namespace espalier {
namespace {

/// Two views of a stick and a block of points beside it, in one window.
class SecondViewTest : public testing::Test {
protected:
  SecondViewTest() : plant_(test::stick(5)) {
    auto* row = new QHBoxLayout(&window_);
    first_ = new PlantView(&window_);
    row->addWidget(first_);
    window_.resize(800, 300);
    first_->setDark(false);
    first_->setPointColor(PointColor::uniform);
    first_->setCloud(test::block({1.5, 0, 2}));
    first_->setSkeleton(plant_);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
    first_->frameAll();
    waitFor(*first_);
    bytesOfOne_ = first_->graphicsBytes();
    second_ = new PlantView(*first_, &window_);
    row->addWidget(second_);
    second_->show();
    waitFor(*first_);
    waitFor(*second_);
  }
  static void waitFor(const PlantView& view) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.isStill(); }));
  }
  [[nodiscard]] static int count(PlantView& view, const Eigen::Vector3d& place,
                                 const Color& color) {
    waitFor(view);
    return test::countPixels(view.grab().toImage(), view.project(place).value(), 4, color, 60);
  }

  Skeleton plant_;
  QWidget window_;
  PlantView* first_ = nullptr;  // owned by the window
  PlantView* second_ = nullptr; // likewise
  std::size_t bytesOfOne_ = 0;
};

const Eigen::Vector3d onStick{0, 0, 1.5};

TEST_F(SecondViewTest, ComesBackToAPlaceFromTheSameSide) {
  const Sight sight{.nodes = {NodeId{2}, NodeId{3}}, .margin = 0.5};
  const Camera chosen = first_->cameraToSee(sight);
  first_->look(StandardView::left);
  waitFor(*first_);
  EXPECT_NE(first_->camera().yaw, chosen.yaw);
  EXPECT_EQ(first_->cameraToSee(sight), chosen);
  EXPECT_NE(first_->cameraToSee({.nodes = {NodeId{2}}, .margin = 0.5}), chosen) << "another place";
  SkeletonEditor editor(plant_);
  editor.setPosition(NodeId{3}, {0.5, 0, 3});
  first_->updateSkeleton(plant_, editor.commit());
  EXPECT_NE(first_->cameraToSee(sight), chosen) << "it was moved";
}

TEST_F(SecondViewTest, ShowsThePlantFromACameraOfItsOwn) {
  second_->look(StandardView::right);
  waitFor(*second_);
  EXPECT_EQ(first_->camera().yaw, 0);
  EXPECT_GT(count(*first_, onStick, test::black), 3);
  EXPECT_GT(count(*second_, onStick, test::black), 3);
  EXPECT_NE(first_->project({1.5, 0, 2})->x(), second_->project({1.5, 0, 2})->x());
}

TEST_F(SecondViewTest, TakesNoMoreOfTheGraphicsCard) {
  EXPECT_GT(bytesOfOne_, std::size_t{64'000 * 16}); // each point has a position and a color
  EXPECT_EQ(second_->graphicsBytes(), bytesOfOne_);
  const Color gray = palette(false).point;
  EXPECT_GT(test::countPixels(second_->grab().toImage(), second_->project({1.5, -0.5, 2}).value(),
                              6, gray, 90),
            20)
      << "and shows the points all the same";
}

TEST_F(SecondViewTest, FollowsEditsThatAreReportedToTheFirst) {
  ASSERT_GT(count(*second_, {0, 0, 3.5}, test::black), 3);
  Skeleton edited = plant_;
  SkeletonEditor editor(edited);
  editor.setPosition(NodeId{4}, {-1, 0, 3});
  first_->updateSkeleton(edited, editor.commit());
  EXPECT_GT(count(*first_, {-0.5, 0, 3}, test::black), 3);
  EXPECT_GT(count(*second_, {-0.5, 0, 3}, test::black), 3);
  EXPECT_EQ(count(*second_, {0, 0, 3.6}, test::black), 0);
}

TEST_F(SecondViewTest, IsClippedAndHiddenAsTheFirst) {
  second_->setClip(
      {.slab = {},
       .box = Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, 2.2), Eigen::Vector3d(1, 1, 5))});
  EXPECT_EQ(first_->clip(), second_->clip());
  EXPECT_EQ(count(*first_, onStick, test::black), 0);
  EXPECT_EQ(count(*second_, onStick, test::black), 0);
  EXPECT_FALSE(second_->pick(second_->project({0, 0, 1}).value()).node);
}

TEST_F(SecondViewTest, ThePlantStaysWhenAViewGoes) {
  delete second_;
  first_->setSelection({NodeId{2}});
  EXPECT_GT(count(*first_, plant_[NodeId{2}].position, palette(false).selected), 3);
  EXPECT_EQ(first_->graphicsBytes(), bytesOfOne_);
}

TEST_F(SecondViewTest, ThePlantStaysWhenTheFirstViewGoes) {
  delete first_;
  second_->setSelection({NodeId{2}});
  EXPECT_GT(count(*second_, plant_[NodeId{2}].position, palette(false).selected), 3);
}

} // namespace
} // namespace espalier
