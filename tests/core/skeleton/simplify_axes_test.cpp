#include "core/skeleton/simplify_axes.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

TEST(WithSimpleAxes, LeavesTheEndsOfAStick) {
  const Skeleton stick = withSimpleAxes(test::stick(50), 1e-9);
  ASSERT_EQ(stick.size(), 2U);
  EXPECT_EQ(stick[NodeId{49}].parent, NodeId{0});
  EXPECT_EQ(stick[NodeId{49}].edge, EdgeType::successor);
}

TEST(WithSimpleAxes, KeepsACorner) {
  Skeleton plant = test::stick(5);
  NodeId last{4};
  for (int i = 1; i <= 4; ++i)
    last = plant.add({.position = {static_cast<double>(i), 0, 4}, .parent = last});
  const Skeleton simple = withSimpleAxes(plant, 0.01);
  ASSERT_EQ(simple.size(), 3U);
  EXPECT_EQ(simple[last].parent, NodeId{4});
}

// A circle of radius 1: a chord over an angle a is off by 1 - cos(a / 2).
TEST(WithSimpleAxes, StaysWithinTheToleranceOnABend) {
  Skeleton plant;
  std::optional<NodeId> last;
  for (int i = 0; i <= 180; ++i) {
    const double turn = i * 3.14159265358979 / 180;
    last = plant.add({.position = {std::cos(turn), 0, std::sin(turn)}, .parent = last});
  }
  const double tolerance = 0.01;
  const Skeleton simple = withSimpleAxes(plant, tolerance);
  const double widest = 2 * std::acos(1 - tolerance); // angle of a chord
  EXPECT_GE(simple.size(), 1 + std::ceil(3.14159 / widest));
  EXPECT_LE(simple.size(), 30U);
  for (const NodeId id : simple.ids())
    if (const auto parent = simple[id].parent) {
      const double chord = (simple[id].position - simple[*parent].position).norm();
      EXPECT_LE(1 - std::sqrt(1 - chord * chord / 4), tolerance + 1e-9);
    }
}

TEST(WithSimpleAxes, KeepsWhatIsAttachedToWhat) {
  Skeleton plant = test::stick(9);
  const NodeId foot =
      plant.add({.position = {1, 0, 4}, .parent = NodeId{4}, .edge = EdgeType::branching});
  const NodeId middle = plant.add({.position = {2, 0, 4}, .parent = foot});
  const NodeId tip = plant.add({.position = {3, 0, 4}, .parent = middle});
  const Skeleton simple = withSimpleAxes(plant, 0.1);
  EXPECT_FALSE(simple.contains(middle));
  EXPECT_EQ(simple[tip].parent, foot);
  EXPECT_EQ(simple[foot].parent, NodeId{4}) << "a branch begins where it began";
  EXPECT_EQ(simple[foot].edge, EdgeType::branching);
  EXPECT_EQ(simple[NodeId{8}].parent, NodeId{4});
  EXPECT_EQ(simple.size(), 5U);
}

TEST(WithSimpleAxes, CopesWithNothingToDo) {
  EXPECT_TRUE(withSimpleAxes({}, 1).isEmpty());
  EXPECT_EQ(withSimpleAxes(test::stick(1), 1), test::stick(1));
  EXPECT_EQ(withSimpleAxes(test::stick(2), 1), test::stick(2));
}

} // namespace
} // namespace espalier
