// What of an extruded and of a skinned hull can be dragged.
#include "core/graph/turn_upright.h"
#include "core/pipeline/envelopes.h"
#include "core/surface/envelopes/extruded_handles.h"
#include "core/surface/envelopes/skinned_handles.h"
#include "tests/support/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A box from (-2, -1, 0) to (2, 1, 2).
ExtrudedHull boxHull() {
  return {.along = {1, 0},
          .middle = {0, 0},
          .ahead = 2,
          .behind = 2,
          .outline = {{-2, -1}, {2, -1}, {2, 1}, {-2, 1}},
          .side = {{0, -2, 2}, {2, -2, 2}}};
}

Envelope pulled(const ExtrudedHull& hull, const std::string& name, const Vector3d& place) {
  return envelopeOf(withHandles(hull, {{name, draggedTo(hull, name, place)}}));
}

/// Points on an egg that leans, about as high as wide.
Eigen::Matrix3Xd eggPoints() {
  Eigen::Matrix3Xd points(3, 600);
  for (int i = 0; i < 600; ++i) {
    const double z = (i + 0.5) / 300 - 1;
    const double angle = 2.4 * i;
    const double out = std::sqrt(1 - z * z) * (1.2 - 0.4 * z);
    points.col(i) = Vector3d(1.5 * out * std::cos(angle) + 0.2 * z, out * std::sin(angle), z);
  }
  return points;
}

Envelope fittedHull(const EnvelopeKind& kind, UpAxis up) {
  return envelopeAbout(turnUpright(up).transpose() * eggPoints(), up, kind,
                       envelopeValues(kind, {}, {.spacing = 0.1, .height = 2}, 0));
}

std::vector<const EnvelopeKind*> profiledKinds() {
  return {&envelopeKindNamed("extruded"), &envelopeKindNamed("skinned")};
}

TEST(HullHandles, RaiseTheTopOfAnExtrudedHull) {
  EXPECT_NEAR(envelopeOf(boxHull()).volume, 16, 1e-12);
  EXPECT_NEAR(pulled(boxHull(), "top", {9, 9, 4}).volume, 32, 1e-9);
  EXPECT_NEAR(pulled(boxHull(), "bottom", {9, 9, 1}).volume, 8, 1e-9);
}

// Half a unit above and below, its width w falls from 5 to 4; its sections are w^2 / 2.
TEST(HullHandles, PullASideOfTheProfileOfAnExtrudedHull) {
  EXPECT_NEAR(pulled(boxHull(), "ahead_middle", {3, 0, 7}).volume, 16 + 13.0 / 6, 1e-9);
  EXPECT_NEAR(pulled(boxHull(), "behind_middle", {-3, 5, 1}).volume, 16 + 13.0 / 6, 1e-9);
}

// From an eighth of a turn to the next but one the outline gets a triangle of area 1.
TEST(HullHandles, PullTheOutlineOfAnExtrudedHull) {
  EXPECT_NEAR(pulled(boxHull(), "outline_left", {0, 2, 1}).volume, 18, 1e-9);
}

TEST(HullHandles, KeepTheOutlineWithinTheEndsOfTheSideProfile) {
  const Envelope envelope = pulled(boxHull(), "outline_ahead_left", {50, 50, 1});
  for (const Vector3d& corner : envelope.mesh.corners)
    EXPECT_LE(corner.x(), 2 + 1e-9);
  EXPECT_GT(envelope.volume, 16);
}

TEST(HullHandles, LetNoSideOfAnExtrudedHullPassTheOther) {
  for (const char* name : {"ahead_low", "behind_high"}) {
    const Envelope envelope = pulled(boxHull(), name, {name[0] == 'a' ? -9.0 : 9.0, 0, 1});
    EXPECT_GT(envelope.volume, 0) << name;
    EXPECT_LT(envelope.volume, 16) << name;
  }
}

TEST(HullHandles, OfTheHullsStandWhereTheyWereDraggedTo) {
  for (const UpAxis up : {UpAxis::z, UpAxis::x})
    for (const EnvelopeKind* kind : profiledKinds()) {
      const Envelope fit = fittedHull(*kind, up);
      const auto handles = envelopeHandles(fit, up, *kind);
      ASSERT_EQ(handles.size(), kind->handles.size());
      for (const EnvelopeHandle& handle : handles) {
        SCOPED_TRACE(kind->form.name + ": " + handle.name);
        const Vector3d to = handle.place - 0.1 * handle.up;
        const HandlePlaces places = {{handle.name, draggedTo(fit, up, *kind, handle.name, to)}};
        const Envelope dragged = draggedEnvelope(fit, up, *kind, places);
        const auto after = envelopeHandles(dragged, up, *kind);
        const auto same = std::ranges::find(after, handle.name, &EnvelopeHandle::name);
        ASSERT_NE(same, after.end());
        EXPECT_LT((same->place - to).norm(), 1e-6);
        EXPECT_NE(dragged.volume, fit.volume);
        EXPECT_EQ(
            test::topologyOf(static_cast<int>(dragged.mesh.corners.size()), dragged.mesh.triangles),
            (test::MeshTopology{.pieces = 1, .boundaryLoops = 0, .eulerCharacteristic = 2}));
      }
    }
}

TEST(HullHandles, LeaveTheHullAsItIsWhereNothingWasDragged) {
  for (const EnvelopeKind* kind : profiledKinds()) {
    const Envelope fit = fittedHull(*kind, UpAxis::z);
    EXPECT_NEAR(draggedEnvelope(fit, UpAxis::z, *kind, {}).volume, fit.volume, 1e-6 * fit.volume);
  }
}

TEST(HullHandles, WidenASkinnedHullOnTheirSideAlone) {
  const EnvelopeKind& kind = envelopeKindNamed("skinned");
  const Envelope fit = fittedHull(kind, UpAxis::z);
  const auto handles = envelopeHandles(fit, UpAxis::z, kind);
  const EnvelopeHandle& middle =
      *std::ranges::find(handles, "side_1_middle", &EnvelopeHandle::name);
  const Vector3d to = middle.place + middle.up;
  const Envelope dragged =
      draggedEnvelope(fit, UpAxis::z, kind,
                      {{"side_1_middle", draggedTo(fit, UpAxis::z, kind, "side_1_middle", to)}});
  EXPECT_GT(dragged.volume, fit.volume);
  const auto after = envelopeHandles(dragged, UpAxis::z, kind);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (handles[i].name == "side_1_middle") continue;
    EXPECT_LT((after[i].place - handles[i].place).norm(), 1e-9) << handles[i].name;
  }
}

TEST(HullHandles, OfASkinnedHullAreThreeOnEachOfUpToEightProfiles) {
  const EnvelopeKind& kind = envelopeKindNamed("skinned");
  for (const auto& [profiles, handles] : {std::pair{3, 11U}, {8, 26U}, {71, 26U}}) {
    const Envelope fit =
        envelopeAbout(eggPoints(), UpAxis::z, kind,
                      envelopeValues(kind, {"profiles=" + std::to_string(profiles)},
                                     {.spacing = 0.1, .height = 2}, 0));
    EXPECT_EQ(envelopeHandles(fit, UpAxis::z, kind).size(), handles);
  }
}

// Places that were dragged on one plant stand on another, too.
TEST(HullHandles, GiveWayWhereTheHullsAreOthers) {
  for (const EnvelopeKind* kind : profiledKinds()) {
    HandlePlaces places;
    for (const std::string& name : kind->handles)
      places[name] = {.out = -7, .level = -5};
    places["top"].level = -9;
    places["no handle of it"] = {};
    const Envelope fit = fittedHull(*kind, UpAxis::z);
    const Envelope dragged = draggedEnvelope(fit, UpAxis::z, *kind, places);
    EXPECT_GT(dragged.volume, 0) << kind->form.name;
    EXPECT_TRUE(std::isfinite(dragged.area));
  }
}

} // namespace
} // namespace espalier
