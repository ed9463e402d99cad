#include "ui/view/drawing_order.h"
#include "ui/view/drawn_looks.h"
#include "ui/view/scene.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <memory>
#include <vector>

namespace espalier {
namespace {

TEST(DrawingOrder, HasEachPointOnceAndKnowsItsRank) {
  for (const Eigen::Index count : {1, 2, 3, 10, 97, 1000, 30'030}) {
    const DrawingOrder order(count);
    std::vector<int> times(static_cast<std::size_t>(count));
    Eigen::Index next = 0;
    for (Eigen::Index rank = 0; rank < count; ++rank, next = order.after(next)) {
      ASSERT_EQ(order.pointAt(rank), next) << count;
      ASSERT_EQ(order.rankOf(next), rank) << count;
      ++times[static_cast<std::size_t>(next)];
    }
    EXPECT_THAT(times, testing::Each(1)) << count;
  }
}

constexpr int count = 50'000; // more than one piece of a loop on all threads

/// A column of points, contracted to the one below; the lowest stays.
Scene columnScene() {
  RawPoints raw;
  for (int z = 0; z < count; ++z)
    raw.positions.emplace_back(0, 0, z);
  Scene scene;
  scene.setCloud(std::make_shared<const PointCloud>(std::move(raw)));
  auto contracted = std::make_shared<Eigen::Matrix3Xf>(scene.cloud->positions());
  contracted->rightCols(count - 1) = scene.cloud->positions().leftCols(count - 1);
  scene.setContracted(contracted);
  return scene;
}

using States = std::vector<PointState>;

void setStates(Scene& scene, States states) {
  scene.setPointStates(std::make_shared<const States>(std::move(states)));
}

class DrawnLooksOf : public testing::TestWithParam<PointPlace> {
protected:
  /// What is drawn is as if nothing had been drawn before.
  void expectFollowed(const char* what) {
    looks_.refresh(scene_);
    DrawnLooks anew(GetParam());
    anew.refresh(scene_);
    EXPECT_EQ(looks_.inOrder(), anew.inOrder()) << what;
  }

  Scene scene_ = columnScene();
  DrawnLooks looks_{GetParam()};
};

TEST_P(DrawnLooksOf, FollowTheStatesOfPoints) {
  expectFollowed("no states");
  States states(count, PointState::normal);
  setStates(scene_, states);
  expectFollowed("all normal");
  const auto paint = [&](int begin, int end, PointState state) {
    std::fill(states.begin() + begin, states.begin() + end, state);
    setStates(scene_, states);
  };
  paint(10, 500, PointState::selected);
  expectFollowed("the first that are selected");
  paint(400, 30'000, PointState::selected);
  expectFollowed("more are selected");
  paint(20'000, 40'000, PointState::hidden);
  expectFollowed("some are hidden");
  paint(100, 200, PointState::dim);
  paint(300, 35'000, PointState::aside);
  expectFollowed("two changes between two looks");
  paint(0, count, PointState::normal);
  expectFollowed("none is selected any more");
  scene_.setPointStates(nullptr);
  expectFollowed("no states again");
}

TEST_P(DrawnLooksOf, FollowColorsThatChangeTogetherWithStates) {
  States states(count, PointState::normal);
  states[7] = PointState::selected;
  setStates(scene_, states);
  expectFollowed("one is selected");
  scene_.setDark(true);
  states[8] = PointState::selected;
  setStates(scene_, states);
  expectFollowed("dark");
  scene_.setPointValues(PointValues{std::make_shared<std::vector<float>>(count, 0.5F), Legend{}});
  states[9] = PointState::selected;
  setStates(scene_, states);
  expectFollowed("values");
  scene_.setContracted(std::make_shared<Eigen::Matrix3Xf>(scene_.cloud->positions()));
  states[10] = PointState::selected;
  setStates(scene_, states);
  expectFollowed("contracted to where they were");
}

INSTANTIATE_TEST_SUITE_P(All, DrawnLooksOf,
                         testing::Values(PointPlace::scanned, PointPlace::contracted));

TEST(DrawnLooks, ShowEachPointInItsState) {
  Scene scene = columnScene();
  States states(count, PointState::normal);
  states[5] = PointState::selected;
  states[6] = PointState::hidden;
  setStates(scene, states);
  const DrawingOrder order(count);
  const auto lookOf = [&](DrawnLooks& looks, Eigen::Index point) {
    return looks.inOrder()[static_cast<std::size_t>(order.rankOf(point))];
  };
  const Color selected = palette(scene.dark).selected;
  DrawnLooks scanned(PointPlace::scanned);
  scanned.refresh(scene);
  EXPECT_EQ(lookOf(scanned, 5), (PointLook{selected[0], selected[1], selected[2], 255}));
  EXPECT_EQ(lookOf(scanned, 6)[3], 0);
  EXPECT_EQ(lookOf(scanned, 0)[3], 255);
  DrawnLooks contracted(PointPlace::contracted);
  contracted.refresh(scene);
  EXPECT_EQ(lookOf(contracted, 5), lookOf(scanned, 5));
  EXPECT_EQ(lookOf(contracted, 0)[3], 0) << "it was not moved: it is shown where it was scanned";
  EXPECT_EQ(lookOf(contracted, 1)[3], 255);
}

} // namespace
} // namespace espalier
