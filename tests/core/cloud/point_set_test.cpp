#include "core/base/random.h"
#include "core/cloud/point_set.h"

#include <gmock/gmock.h>
#include <set>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(PointSet, KeepsNeighborsAsOneRun) {
  const PointSet set = PointSet::of({2, 3, 4, 9});
  EXPECT_THAT(set.runs(), ElementsAre(PointSet::Run{2, 5}, PointSet::Run{9, 10}));
  EXPECT_EQ(set.size(), 4U);
  EXPECT_THAT(set.points(), ElementsAre(2, 3, 4, 9));
  EXPECT_TRUE(PointSet::of({}).isEmpty());
  EXPECT_EQ(PointSet::firstOf(3), PointSet::of({0, 1, 2}));
  EXPECT_TRUE(PointSet::firstOf(0).isEmpty());
}

TEST(PointSet, KnowsItsPoints) {
  const PointSet set = PointSet::of({2, 3, 9});
  for (const Eigen::Index point : {2, 3, 9})
    EXPECT_TRUE(set.contains(point)) << point;
  for (const Eigen::Index point : {0, 1, 4, 8, 10})
    EXPECT_FALSE(set.contains(point)) << point;
  EXPECT_FALSE(PointSet().contains(0));
}

// Against sets that keep each point on its own.
TEST(PointSet, JoinsAndPartsAsSetsDo) {
  Random random(4);
  for (int round = 0; round < 200; ++round) {
    std::set<Eigen::Index> a;
    std::set<Eigen::Index> b;
    for (int i = 0; i < 12; ++i) {
      a.insert(static_cast<Eigen::Index>(random.below(20)));
      b.insert(static_cast<Eigen::Index>(random.below(20)));
    }
    const PointSet x = PointSet::of({a.begin(), a.end()});
    const PointSet y = PointSet::of({b.begin(), b.end()});
    std::vector<Eigen::Index> either, both, alone, one;
    for (Eigen::Index i = 0; i < 20; ++i) {
      const bool inA = a.contains(i);
      const bool inB = b.contains(i);
      if (inA || inB) either.push_back(i);
      if (inA && inB) both.push_back(i);
      if (inA && !inB) alone.push_back(i);
      if (inA != inB) one.push_back(i);
    }
    ASSERT_EQ(x | y, PointSet::of(either));
    ASSERT_EQ(x & y, PointSet::of(both));
    ASSERT_EQ(x - y, PointSet::of(alone));
    ASSERT_EQ(x ^ y, PointSet::of(one));
  }
}

TEST(PointSet, IsItsOwnInverse) {
  const PointSet before = PointSet::of({1, 2, 3});
  const PointSet turned = PointSet::of({3, 4});
  EXPECT_EQ((before ^ turned) ^ turned, before);
}

TEST(PointSet, IsNotMadeOfRunsThatAreNone) {
  EXPECT_TRUE(PointSet::ofRuns({}));
  EXPECT_EQ(PointSet::ofRuns({{2, 4}, {5, 6}}), PointSet::of({2, 3, 5}));
  EXPECT_FALSE(PointSet::ofRuns({{4, 4}})) << "empty";
  EXPECT_FALSE(PointSet::ofRuns({{5, 4}})) << "backward";
  EXPECT_FALSE(PointSet::ofRuns({{2, 4}, {4, 6}})) << "one run";
  EXPECT_FALSE(PointSet::ofRuns({{5, 6}, {1, 2}})) << "out of order";
}

TEST(PointSet, LeavesTheOthers) {
  EXPECT_THAT(others(PointSet::of({0, 2}), 4), ElementsAre(1, 3));
  EXPECT_THAT(others(PointSet::of({0, 2, 9}), 2), ElementsAre(1)) << "there are but two points";
  EXPECT_THAT(others(PointSet::firstOf(4), 4), IsEmpty());
}

TEST(PointSet, IsTakenOutOfACloud) {
  RawPoints raw;
  for (int i = 0; i < 4; ++i) {
    raw.positions.emplace_back(i, 0, 100);
    raw.intensities.push_back(static_cast<float>(i));
  }
  const PointCloud cloud(std::move(raw));
  const PointCloud rest = without(cloud, PointSet::of({1, 2}));
  ASSERT_EQ(rest.size(), 2);
  EXPECT_EQ(rest.origin(), cloud.origin());
  for (const auto& [column, of] : {std::pair{0, 0}, {1, 3}}) {
    EXPECT_EQ(rest.position(column), cloud.position(of));
    EXPECT_EQ(rest.intensities()[static_cast<std::size_t>(column)],
              cloud.intensities()[static_cast<std::size_t>(of)]);
    EXPECT_EQ(rest.fileOrder()[static_cast<std::size_t>(column)],
              cloud.fileOrder()[static_cast<std::size_t>(of)]);
  }
  EXPECT_TRUE(without(cloud, PointSet::firstOf(4)).isEmpty());
}

} // namespace
} // namespace espalier
