#include "core/base/random.h"
#include "core/radius/section_circle.h"
#include "tests/core/radius/circle_of.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace espalier {
namespace {

/// A scan, and sections of a skeleton over it.
struct Sections {
  Skeleton skeleton;
  Eigen::Matrix3Xf points;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  SpatialIndex index{points};
  CrossSections sections{skeleton, {points, origin, index, 0.01}};

  Sections(Skeleton plant, Eigen::Matrix3Xf scan)
      : skeleton(std::move(plant)), points(std::move(scan)) {}
};

CrossSection sectionAt(const Sections& of, NodeId id) {
  const std::optional<CrossSection> section = of.sections.at(id);
  EXPECT_TRUE(section.has_value());
  return section.value_or(CrossSection{});
}

/// Nodes 0.1 apart on the line of a cylinder of radius 0.1.
Skeleton rod(const Eigen::Vector3d& direction, double radius = 0.1) {
  Skeleton skeleton;
  std::optional<NodeId> parent;
  for (int i = 0; i <= 10; ++i)
    parent = skeleton.add({.position = 0.1 * i * direction, .radius = radius, .parent = parent});
  return skeleton;
}

constexpr NodeId middle{5};

TEST(CrossSections, OfAnObliqueCylinderAreRound) {
  const Eigen::Vector3d direction = Eigen::Vector3d(1, 2, 1.5).normalized();
  const Sections oblique(rod(direction), test::cylinder({0, 0, 0}, direction, 0.1, 0.01));
  const CrossSection section = sectionAt(oblique, middle);
  EXPECT_GT(section.points.size(), 100U);
  EXPECT_TRUE(section.others.empty());
  for (const Eigen::Vector2d& point : section.points)
    EXPECT_NEAR(point.norm(), 0.1, 1e-6);
  EXPECT_NEAR(section.right.dot(direction), 0, 1e-12);
  EXPECT_NEAR(section.right.cross(section.up).dot(direction), 1, 1e-12);
}

TEST(CrossSections, HaveUpUpAndTheTipTowardsTheEye) {
  const Sections lying(rod({0, 1, 0}), test::cylinder({0, 0, 0}, {0, 1, 0}, 0.1, 0.01));
  EXPECT_TRUE(sectionAt(lying, middle).up.isApprox(Eigen::Vector3d(0, 0, 1)));
  const Sections upright(rod({0, 0, 1}), test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01));
  EXPECT_TRUE(sectionAt(upright, middle).up.isApprox(Eigen::Vector3d(0, 1, 0)));
  EXPECT_TRUE(sectionAt(upright, middle).right.isApprox(Eigen::Vector3d(1, 0, 0)));
}

TEST(CrossSections, ReturnWhereAPlaceOfThemIs) {
  const Sections upright(rod({0, 0, 1}), test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01));
  EXPECT_TRUE(
      sectionAt(upright, middle).place({0.2, 0.3}).isApprox(Eigen::Vector3d(0.2, 0.3, 0.5)));
}

// Two rods side by side: the points of each belong to the nearer one.
TEST(CrossSections, LeaveThePointsOfAnotherBranchToIt) {
  Skeleton pair = rod({0, 0, 1});
  std::optional<NodeId> parent = NodeId{0};
  for (int i = 0; i <= 10; ++i)
    parent = pair.add({.position = {0.22, 0, 0.1 * i},
                       .radius = 0.1,
                       .parent = parent,
                       .edge = i == 0 ? EdgeType::branching : EdgeType::successor});
  const Sections both(pair, test::both(test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01),
                                       test::cylinder({0.22, 0, 0}, {0.22, 0, 1}, 0.1, 0.01, 2)));
  const CrossSection section = sectionAt(both, middle);
  for (const Eigen::Vector2d& point : section.points)
    EXPECT_NEAR(point.norm(), 0.1, 1e-6);
  EXPECT_EQ(test::circleOf(section, RadiusMeasure::mean).coverage, 1);
  EXPECT_GT(section.others.size(), 50U) << "they are shown";
}

// A thin branch leaves at a right angle: nearest edges alone would give it half of the stem.
TEST(CrossSections, KeepAStemWholeWhereATwigLeavesIt) {
  Skeleton plant = rod({0, 0, 1});
  std::optional<NodeId> parent = middle;
  for (int i = 1; i <= 5; ++i)
    parent = plant.add({.position = {0.1 * i, 0, 0.5},
                        .radius = 0.02,
                        .parent = parent,
                        .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
  const Sections stem(plant, test::both(test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01),
                                        test::cylinder({0.1, 0, 0.5}, {0.5, 0, 0.5}, 0.02, 0.01)));
  const CrossSection section = sectionAt(stem, middle);
  EXPECT_GE(test::circleOf(section, RadiusMeasure::mean).coverage, 15.0 / 16);
  EXPECT_NEAR(test::circleOf(section, RadiusMeasure::circle).radius, 0.1, 0.002);
  EXPECT_LT(test::circleOf(section, RadiusMeasure::maximum).radius, 0.13) << "no point of the twig";
}

TEST(CrossSections, FindTheWoodWhateverTheRadiusOfTheNode) {
  const Eigen::Matrix3Xf wood = test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01);
  for (const double radius : {0.0, 0.01, 1.0}) {
    Skeleton skeleton = rod({0, 0, 1}, 0.1);
    skeleton.setRadius(middle, radius);
    const Sections one(skeleton, wood);
    EXPECT_NEAR(test::circleOf(sectionAt(one, middle), RadiusMeasure::circle).radius, 0.1, 0.001);
    const Sections all(rod({0, 0, 1}, radius), wood);
    EXPECT_NEAR(test::circleOf(sectionAt(all, middle), RadiusMeasure::circle).radius, 0.1, 0.001);
  }
}

TEST(CrossSections, FindTheFarWallFromANodeAtTheNearOne) {
  Skeleton skeleton = rod({0, 0, 1}, 0);
  for (const NodeId id : skeleton.ids())
    skeleton.setPosition(id, skeleton[id].position + Eigen::Vector3d(0.095, 0, 0));
  const Sections beside(skeleton, test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01));
  const FittedCircle circle = test::circleOf(sectionAt(beside, middle), RadiusMeasure::circle);
  EXPECT_NEAR(circle.radius, 0.1, 0.001);
  EXPECT_NEAR(circle.center.x(), -0.095, 0.001);
}

TEST(CrossSections, EndAtAWideGap) {
  const Sections stem(rod({0, 0, 1}),
                      test::both(test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01),
                                 test::cylinder({0.25, 0, 0}, {0.25, 0, 1}, 0.02, 0.01)));
  EXPECT_NEAR(test::circleOf(sectionAt(stem, middle), RadiusMeasure::maximum).radius, 0.1, 1e-6)
      << "a twig of no edge is no wood of this stem";
}

TEST(CrossSections, AreMovedAndScaledWithThePlant) {
  const Eigen::Matrix3Xf wood = test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01);
  const Sections here(rod({0, 0, 1}), wood);
  const Eigen::Vector3d far(600000, 5000000, 100);
  Skeleton moved = rod({0, 0, 1});
  for (const NodeId id : moved.ids())
    moved.setPosition(id, moved[id].position + far);
  const SpatialIndex index(wood);
  const CrossSections there(moved, {wood, far, index, 0.01});
  EXPECT_EQ(there.at(middle)->points.size(), sectionAt(here, middle).points.size());
  Skeleton large = rod({0, 0, 1});
  for (const NodeId id : large.ids()) {
    large.setPosition(id, 1000 * large[id].position);
    large.setRadius(id, 100);
  }
  const Eigen::Matrix3Xf largeWood = 1000 * wood;
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  const SpatialIndex largeIndex(largeWood);
  const CrossSections scaled(large, {largeWood, origin, largeIndex, 10});
  EXPECT_NEAR(test::circleOf(*scaled.at(middle), RadiusMeasure::circle).radius, 100, 0.5);
}

TEST(CrossSections, AreNoneWithoutADirection) {
  const Eigen::Matrix3Xf wood = test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01);
  const Sections alone(test::stick(1), wood);
  EXPECT_FALSE(alone.sections.at(NodeId{0}));
  const Sections folded(rod({0, 0, 0}), wood);
  EXPECT_FALSE(folded.sections.at(middle));
  const Sections bare(rod({0, 0, 1}), Eigen::Matrix3Xf(3, 0));
  EXPECT_FALSE(bare.sections.at(middle));
}

TEST(CrossSections, AreEmptyBeyondTheEndOfTheWood) {
  const Sections above(rod({0, 0, 1}), test::cylinder({0, 0, 0}, {0, 0, 0.3}, 0.1, 0.01));
  EXPECT_TRUE(sectionAt(above, NodeId{8}).points.empty());
}

TEST(SectionRadii, CountWhatWasRefused) {
  Skeleton plant = rod({0, 0, 1});
  const NodeId alone = plant.add({.position = {3, 3, 3}});
  const Sections half(plant, test::cylinder({0, 0, 0}, {0, 0, 0.5}, 0.1, 0.01));
  const SectionRadii radii =
      sectionRadii(half.sections, {NodeId{2}, NodeId{10}, alone}, RadiusMeasure::circle);
  ASSERT_EQ(radii.radii.size(), 1U);
  EXPECT_EQ(radii.radii[0].first, NodeId{2});
  EXPECT_NEAR(radii.radii[0].second, 0.1, 0.001);
  EXPECT_EQ(radii.refused[static_cast<std::size_t>(NoRadius::fewPoints)], 1U);
  EXPECT_EQ(radii.refused[static_cast<std::size_t>(NoRadius::noSection)], 1U);
}

TEST(SectionRadii, StopWhenAsked) {
  const Sections stem(rod({0, 0, 1}), test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.01));
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    (void)sectionRadii(stem.sections, stem.skeleton.ids(), RadiusMeasure::circle, progress);
  }));
}

} // namespace
} // namespace espalier
