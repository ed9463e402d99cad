#include "core/graph/turn_upright.h"
#include "core/pipeline/envelopes.h"
#include "core/surface/envelopes/envelope_handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr double ballVolume = 4 * std::numbers::pi / 3;

/// A ball of radius 1.
AsymmetricHull unitBall() {
  return {.center = {3, 4},
          .azimuth = 0,
          .radii = {1, 1, 1, 1},
          .heights = {0, 0, 0, 0},
          .top = {3, 4, 1},
          .bottom = {3, 4, -1}};
}

const EnvelopeHandle& handleNamed(const std::vector<EnvelopeHandle>& handles,
                                  const std::string& name) {
  return *std::ranges::find(handles, name, &EnvelopeHandle::name);
}

TEST(EnvelopeHandles, StandWhereTheHullReaches) {
  const std::vector<EnvelopeHandle> handles = handlesOf(unitBall());
  ASSERT_EQ(handles.size(), 6U);
  EXPECT_EQ(handleNamed(handles, "top").place, Eigen::Vector3d(3, 4, 1));
  EXPECT_TRUE(handleNamed(handles, "top").outward.isZero());
  EXPECT_LT((handleNamed(handles, "ahead").place - Eigen::Vector3d(4, 4, 0)).norm(), 1e-12);
  EXPECT_LT((handleNamed(handles, "left").place - Eigen::Vector3d(3, 5, 0)).norm(), 1e-12);
  EXPECT_LT((handleNamed(handles, "right").place - Eigen::Vector3d(3, 3, 0)).norm(), 1e-12);
}

// Two of four quarters get twice as long: each is as large as the product of its two radii.
TEST(EnvelopeHandles, SetTheRadiusOfASide) {
  const HandlePlace place = draggedTo(unitBall(), "ahead", {5, 9, 0});
  EXPECT_DOUBLE_EQ(place.out, 2);
  EXPECT_DOUBLE_EQ(place.level, 0);
  const AsymmetricHull hull = withHandles(unitBall(), {{"ahead", place}});
  EXPECT_NEAR(volume(hull), 1.5 * ballVolume, 1e-9);
  EXPECT_NEAR(volume(meshOf(hull)), 1.5 * ballVolume, 0.01 * ballVolume);
}

TEST(EnvelopeHandles, SetHowHighTheTopIs) {
  const AsymmetricHull hull =
      withHandles(unitBall(), {{"top", draggedTo(unitBall(), "top", {8, 9, 3})}});
  EXPECT_EQ(hull.top, Eigen::Vector3d(3, 4, 3)) << "it goes up and down alone";
  EXPECT_NEAR(volume(hull), (0.5 + 1.5) * ballVolume, 1e-9) << "its upper half is 3 high";
}

TEST(EnvelopeHandles, KeepBottomSidesAndTopAboveEachOther) {
  EXPECT_DOUBLE_EQ(draggedTo(unitBall(), "top", {3, 4, -5}).level, 0) << "not below a side";
  EXPECT_DOUBLE_EQ(draggedTo(unitBall(), "bottom", {3, 4, 5}).level, 0);
  EXPECT_DOUBLE_EQ(draggedTo(unitBall(), "left", {3, 6, 7}).level, 1) << "not above the top";
  EXPECT_DOUBLE_EQ(draggedTo(unitBall(), "left", {3, 6, -7}).level, -1);
  AsymmetricHull leaning = unitBall();
  leaning.top.x() += 0.5;
  EXPECT_NEAR(draggedTo(leaning, "ahead", {-7, 4, 0}).out, 0.5, 0.001) << "the top stands there";
  EXPECT_GT(draggedTo(leaning, "behind", {9, 4, 0}).out, 0);
  EXPECT_LT(draggedTo(leaning, "behind", {9, 4, 0}).out, 0.01);
}

// Places that were dragged on one plant stand on another, too.
TEST(EnvelopeHandles, GiveWayWhereTheHullIsAnother) {
  const AsymmetricHull hull = withHandles(
      unitBall(),
      {{"top", {.level = -3}}, {"ahead", {.out = 1, .level = 5}}, {"left", {.out = -1}}});
  EXPECT_GE(hull.top.z(), *std::ranges::max_element(hull.heights));
  EXPECT_LE(hull.bottom.z(), *std::ranges::min_element(hull.heights));
  EXPECT_GT(volume(hull), 0);
}

TEST(EnvelopeHandles, AreReadFromTheParameters) {
  AsymmetricHull hull = unitBall();
  hull.azimuth = 0.7;
  hull.radii = {1, 2, 3, 4};
  hull.heights = {0.1, 0.2, 0.3, 0.4};
  hull.topShape = 1.5;
  const AsymmetricHull read = asymmetricHullOf(envelopeOf(hull).parameters);
  EXPECT_EQ(read.center, hull.center);
  EXPECT_EQ(read.radii, hull.radii);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(read.heights[i], hull.heights[i], 1e-12);
  EXPECT_EQ(read.top, hull.top);
  EXPECT_EQ(read.azimuth, 0.7);
  EXPECT_EQ(read.topShape, 1.5);
}

// A crown that lies along x: its handles are where the same one has them that stands.
TEST(EnvelopeHandles, FollowTheAxisThatPointsUp) {
  Eigen::Matrix3Xd points(3, 400);
  for (int i = 0; i < 400; ++i) {
    const double z = (i + 0.5) / 200 - 1;
    const double angle = 2.4 * i;
    const double out = std::sqrt(1 - z * z);
    points.col(i) = Eigen::Vector3d(2 * out * std::cos(angle), out * std::sin(angle), z);
  }
  const EnvelopeKind& kind = envelopeKindNamed("asymmetric");
  const std::vector<double> values = envelopeValues(kind, {}, {.spacing = 0.1, .height = 2}, 0);
  const Eigen::Matrix3d turn = turnUpright(UpAxis::x);
  const Eigen::Matrix3Xd lying = turn.transpose() * points;
  const Envelope standing = envelopeAbout(points, UpAxis::z, kind, values);
  const Envelope laid = envelopeAbout(lying, UpAxis::x, kind, values);
  const auto handles = envelopeHandles(standing, UpAxis::z, kind);
  const auto turned = envelopeHandles(laid, UpAxis::x, kind);
  ASSERT_EQ(handles.size(), turned.size());
  for (std::size_t i = 0; i < handles.size(); ++i)
    EXPECT_LT((turn * turned[i].place - handles[i].place).norm(), 1e-3);
  const Eigen::Vector3d higher = turned[0].place + 2 * Eigen::Vector3d::UnitX();
  const HandlePlaces places = {{"top", draggedTo(laid, UpAxis::x, kind, "top", higher)}};
  const Envelope dragged = draggedEnvelope(laid, UpAxis::x, kind, places);
  EXPECT_LT((envelopeHandles(dragged, UpAxis::x, kind)[0].place - higher).norm(), 1e-9);
  EXPECT_GT(dragged.volume, 1.5 * laid.volume) << "the upper half is three times as high";
  EXPECT_TRUE(envelopeHandles(laid, UpAxis::x, envelopeKindNamed("convex")).empty());
}

} // namespace
} // namespace espalier
