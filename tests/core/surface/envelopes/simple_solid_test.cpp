#include "core/graph/turn_upright.h"
#include "core/pipeline/envelopes.h"
#include "core/surface/envelopes/simple_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// The corners of a leaning body, 2 x 3 x 4 long.
Eigen::Matrix3Xd leaningCorners() {
  Eigen::Matrix3Xd corners(3, 8);
  for (int i = 0; i < 8; ++i)
    corners.col(i) = Vector3d(i & 1 ? 2 : 0, i & 2 ? 3 : 0, i & 4 ? 4 : 0);
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.4, Vector3d::UnitX()) * Eigen::AngleAxisd(0.3, Vector3d::UnitZ()))
          .toRotationMatrix();
  return (turn * corners).colwise() + Vector3d(5, 6, 7);
}

std::vector<const EnvelopeKind*> solids() {
  std::vector<const EnvelopeKind*> result;
  for (const EnvelopeKind& kind : envelopeKinds())
    if (std::ranges::count(kind.handles, "center") > 0) result.push_back(&kind);
  return result;
}

Envelope fitted(const EnvelopeKind& kind, UpAxis up) {
  const Eigen::Matrix3Xd points = turnUpright(up).transpose() * leaningCorners();
  return envelopeAbout(points, up, kind, envelopeValues(kind, {}, {.spacing = 1, .height = 4}, 0));
}

SimpleSolid solid(SimpleSolid::Kind kind, std::array<double, 3> reaches) {
  return {.kind = kind, .center = {3, 4, 0}, .bottom = -1, .top = 1, .reaches = reaches};
}

/// The same with one handle dragged.
SimpleSolid dragged(const SimpleSolid& solid, const std::string& name, const Vector3d& place) {
  return withHandles(solid, {{name, draggedTo(solid, name, place)}});
}

const EnvelopeHandle& handleOf(const std::vector<EnvelopeHandle>& handles,
                               const std::string& name) {
  return *std::ranges::find(handles, name, &EnvelopeHandle::name);
}

TEST(SimpleSolids, AreMadeAnewFromTheirParametersWhicheverAxisPointsUp) {
  ASSERT_EQ(solids().size(), 7U);
  for (const EnvelopeKind* kind : solids())
    for (const UpAxis up : {UpAxis::z, UpAxis::x, UpAxis::y}) {
      SCOPED_TRACE(kind->form.name);
      const Envelope made = fitted(*kind, up);
      const Envelope again = draggedEnvelope(made, up, *kind, {});
      EXPECT_NEAR(again.volume, made.volume, 1e-9 * made.volume);
      EXPECT_NEAR(again.area, made.area, 1e-9 * made.area);
      EXPECT_NEAR(again.height, made.height, 1e-9 * made.height);
      ASSERT_EQ(again.parameters.size(), made.parameters.size());
      for (std::size_t i = 0; i < made.parameters.size(); ++i) {
        EXPECT_EQ(again.parameters[i].name, made.parameters[i].name);
        EXPECT_NEAR(again.parameters[i].value, made.parameters[i].value, 1e-9);
      }
      ASSERT_EQ(again.mesh.corners.size(), made.mesh.corners.size());
      for (std::size_t i = 0; i < made.mesh.corners.size(); ++i)
        EXPECT_LT((again.mesh.corners[i] - made.mesh.corners[i]).norm(), 1e-9);
    }
}

// Pulled away from the center, each handle follows, and the solid grows.
TEST(SimpleSolids, ComeAlongWithTheirHandles) {
  for (const EnvelopeKind* kind : solids())
    for (const UpAxis up : {UpAxis::z, UpAxis::x}) {
      const Envelope made = fitted(*kind, up);
      for (const EnvelopeHandle& handle : envelopeHandles(made, up, *kind)) {
        SCOPED_TRACE(kind->form.name + ": " + handle.name);
        const double sign = handle.name == "bottom" ? -0.5 : 0.5;
        const Vector3d to = handle.place + sign * handle.up;
        const HandlePlaces places = {{handle.name, draggedTo(made, up, *kind, handle.name, to)}};
        const Envelope after = draggedEnvelope(made, up, *kind, places);
        if (handle.isFree) {
          EXPECT_NEAR(after.volume, made.volume, 1e-9 * made.volume);
          continue;
        }
        EXPECT_GT(after.volume, 1.05 * made.volume);
        const auto moved = envelopeHandles(after, up, *kind);
        EXPECT_LT((handleOf(moved, handle.name).place - to).norm(), 1e-9);
      }
    }
}

TEST(SimpleSolids, HaveTheVolumeOfWhatWasDragged) {
  using Kind = SimpleSolid::Kind;
  const SimpleSolid ball = dragged(solid(Kind::ball, {1}), "radius", {5, 9, 9});
  EXPECT_NEAR(envelopeOf(ball).volume, 8 * 4 * std::numbers::pi / 3, 1e-9) << "its radius is 2";
  const SimpleSolid cylinder = dragged(solid(Kind::cylinder, {1}), "top", {9, 9, 2});
  EXPECT_NEAR(envelopeOf(cylinder).volume, 3 * std::numbers::pi, 1e-9) << "it is 3 high";
  const SimpleSolid cone = dragged(solid(Kind::cone, {1}), "bottom", {9, 9, -2});
  EXPECT_NEAR(envelopeOf(cone).volume, std::numbers::pi, 1e-9) << "likewise";
  const SimpleSolid frustum = dragged(solid(Kind::frustum, {1, 1}), "top_radius", {5, 4, 1});
  EXPECT_NEAR(envelopeOf(frustum).volume, 2 * std::numbers::pi * (1 + 2 + 4) / 3, 1e-9);
  const SimpleSolid box = dragged(solid(Kind::box, {1, 1}), "length", {6, 4, 0});
  EXPECT_NEAR(envelopeOf(box).volume, 6 * 2 * 2, 1e-9) << "it reaches 3 to both sides";
}

TEST(SimpleSolids, MoveWithTheirCenter) {
  const SimpleSolid ball = dragged(solid(SimpleSolid::Kind::ball, {1}), "center", {7, 8, 9});
  EXPECT_EQ(ball.center, Vector3d(7, 8, 9));
  const SimpleSolid box = dragged(solid(SimpleSolid::Kind::box, {1, 1}), "center", {7, 8, 9});
  EXPECT_EQ(placeOf(envelopeOf(box).parameters, "center"), Vector3d(7, 8, 0))
      << "top and bottom stay";
}

TEST(SimpleSolids, FillSomeSpaceWhereverHandlesArePulled) {
  using Kind = SimpleSolid::Kind;
  for (const Kind kind : {Kind::ball, Kind::ellipsoid, Kind::cylinder, Kind::cone, Kind::frustum,
                          Kind::paraboloid, Kind::box}) {
    SimpleSolid pulled = solid(kind, {1, 1, 1});
    for (const EnvelopeHandle& handle : handlesOf(pulled))
      for (const double far : {-50.0, 50.0}) {
        const Envelope made = envelopeOf(dragged(pulled, handle.name, Vector3d::Constant(far)));
        EXPECT_GT(made.volume, 0) << handle.name;
        EXPECT_GT(made.height, 0) << handle.name;
      }
    pulled = withHandles(pulled, {{"top", {.level = -9}}, {"radius", {.out = -1}}});
    EXPECT_GT(envelopeOf(pulled).volume, 0) << "as if dragged on another plant";
  }
}

TEST(SimpleSolids, KindsThatFollowThePointsHaveNoHandles) {
  for (const char* name : {"convex", "alpha"})
    EXPECT_FALSE(envelopeKindNamed(name).hasHandles()) << name;
}

} // namespace
} // namespace espalier
