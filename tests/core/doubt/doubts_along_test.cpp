#include "core/doubt/doubts_along.h"
#include "tests/support/cloud_of.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::Optional;

constexpr double near = 0.05;

/// Points every 0.1 along x from 0 to 2, at this height.
PointCloud row(float height) {
  Eigen::Matrix3Xf points(3, 21);
  for (int i = 0; i < 21; ++i)
    points.col(i) << 0.1F * static_cast<float>(i), 0, height;
  return *test::cloudAtOrigin(points);
}

/// About the points between these places along x.
Finding ofPoints(const PointCloud& cloud, double from, double to) {
  Finding finding{.kind = Finding::Kind::unexplainedPoints, .node = NodeId(0)};
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    if (cloud.position(i).x() > from && cloud.position(i).x() < to) finding.points.push_back(i);
  return finding;
}

/// A branch along x, at height 0.
Doubt missing(double from, double to) {
  Skeleton part;
  const NodeId root = part.add({.position = {from, 0, 0}});
  part.add({.position = {to, 0, 0}, .radius = 0.01, .parent = root});
  Doubt doubt{.kind = Doubt::Kind::missing};
  doubt.alternatives = {
      {.kind = Alternative::Kind::add, .branch = GrownBranch{.on = NodeId(0), .part = part}},
      {.kind = Alternative::Kind::asItIs}};
  return doubt;
}

TEST(DoubtsAlong, AreAboutMostOfThePoints) {
  const PointCloud cloud = row(0);
  const std::vector<Finding> findings = {ofPoints(cloud, -0.05, 0.95), ofPoints(cloud, 1.05, 2.05)};
  EXPECT_THAT(doubtsAlong(findings, {missing(0, 0.6)}, cloud, near),
              ElementsAre(Optional(0U), std::nullopt));
  EXPECT_THAT(doubtsAlong(findings, {missing(0, 0.3)}, cloud, near),
              ElementsAre(std::nullopt, std::nullopt))
      << "4 of 10";
  EXPECT_THAT(doubtsAlong(findings, {missing(0, 0.2), missing(0.3, 2)}, cloud, near),
              ElementsAre(Optional(1U), Optional(1U)))
      << "the one along more";
  EXPECT_THAT(doubtsAlong(findings, {missing(0, 0.3), missing(0.6, 0.9)}, cloud, near),
              ElementsAre(Optional(0U), std::nullopt))
      << "8 of 10 by both";
}

TEST(DoubtsAlong, AreNotOfPointsBesideThem) {
  const PointCloud cloud = row(0.06F);
  const std::vector<Finding> findings = {ofPoints(cloud, -1, 3)};
  EXPECT_THAT(doubtsAlong(findings, {missing(0, 2)}, cloud, near), ElementsAre(std::nullopt));
  Doubt thick = missing(0, 2);
  thick.alternatives[0].branch->part.setRadius(NodeId(1), 0.04);
  EXPECT_THAT(doubtsAlong(findings, {thick}, cloud, near), ElementsAre(Optional(0U)))
      << "points lie on the surface of wood";
}

TEST(DoubtsAlong, AreOfFindingsOfPointsAlone) {
  const Finding turn{.kind = Finding::Kind::sharpTurn, .node = NodeId(0)};
  EXPECT_THAT(doubtsAlong({turn}, {missing(0, 2)}, row(0), near), ElementsAre(std::nullopt));
}

} // namespace
} // namespace espalier
