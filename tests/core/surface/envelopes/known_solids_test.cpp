// Envelopes of points in and on solids whose volumes are known.
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/graph/turn_upright.h"
#include "core/pipeline/envelopes.h"
#include "core/surface/envelopes/asymmetric_hull.h"
#include "tests/support/mesh_topology.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

constexpr double pi = std::numbers::pi;

using Inside = std::function<bool(const Eigen::Vector3d&)>;

/// Points evenly in a solid that is within a box from -size to size, `count` of them.
Eigen::Matrix3Xd pointsIn(const Inside& isInside, const Eigen::Vector3d& size, Eigen::Index count) {
  Random random(7);
  Eigen::Matrix3Xd points(3, count);
  for (Eigen::Index i = 0; i < count;) {
    const Eigen::Vector3d at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (isInside(at.cwiseProduct(size))) points.col(i++) = at.cwiseProduct(size);
  }
  return points;
}

/// The same, with as many on its surface, where rays from the origin leave it.
Eigen::Matrix3Xd pointsInAndOn(const Inside& isInside, const Eigen::Vector3d& size,
                               Eigen::Index count) {
  Eigen::Matrix3Xd points(3, 2 * count);
  points.leftCols(count) = pointsIn(isInside, size, count);
  Random random(8);
  for (Eigen::Index i = count; i < 2 * count; ++i) {
    const Eigen::Vector3d along = random.direction();
    double in = 0;
    double out = 2 * size.norm();
    for (int step = 0; step < 50; ++step)
      (isInside((in + out) / 2 * along) ? in : out) = (in + out) / 2;
    points.col(i) = in * along;
  }
  return points;
}

Envelope envelopeNamed(const std::string& name, const Eigen::Matrix3Xd& points,
                       UpAxis up = UpAxis::z, const std::vector<std::string>& settings = {}) {
  const EnvelopeKind& kind = envelopeKindNamed(name);
  return envelopeAbout(points, up, kind,
                       envelopeValues(kind, settings, {.spacing = 0.05, .height = 3}, 0));
}

double parameterOf(const Envelope& envelope, const std::string& name) {
  for (const EnvelopeParameter& parameter : envelope.parameters)
    if (parameter.name == name) return parameter.value;
  ADD_FAILURE() << "no parameter " << name;
  return 0;
}

bool inBall(const Eigen::Vector3d& at) {
  return at.norm() <= 1.5;
}
bool inCylinder(const Eigen::Vector3d& at) {
  return at.head<2>().norm() <= 1 && std::abs(at.z()) <= 1.5;
}
bool inCone(const Eigen::Vector3d& at) { // 3 high, 1 wide at its foot
  return std::abs(at.z()) <= 1.5 && at.head<2>().norm() <= (1.5 - at.z()) / 3;
}
bool inFrustum(const Eigen::Vector3d& at) { // wider above
  return std::abs(at.z()) <= 1.5 && at.head<2>().norm() <= 0.7 + at.z() / 5;
}
bool inParaboloid(const Eigen::Vector3d& at) {
  return std::abs(at.z()) <= 1.5 && at.head<2>().squaredNorm() <= (1.5 - at.z()) / 3;
}
bool inBox(const Eigen::Vector3d& at) {
  return (at.array().abs() <= Eigen::Array3d(2, 1, 1.5)).all();
}
bool inEllipsoid(const Eigen::Vector3d& at) {
  return (at.array() / Eigen::Array3d(2, 1, 1.5)).matrix().norm() <= 1;
}
bool inRing(const Eigen::Vector3d& at) { // a torus
  return std::hypot(at.head<2>().norm() - 1, at.z()) <= 0.4;
}

const Eigen::Vector3d sides(2, 1, 1.5);

void expectWithin(double value, double truth, double share) {
  EXPECT_NEAR(value, truth, share * truth);
}

void expectClosed(const Envelope& envelope) {
  const auto corners = static_cast<int>(envelope.mesh.corners.size());
  EXPECT_EQ(test::topologyOf(corners, envelope.mesh.triangles),
            (test::MeshTopology{.pieces = 1, .boundaryLoops = 0, .eulerCharacteristic = 2}));
  EXPECT_NEAR(volume(envelope.mesh), envelope.volume, 2e-3 * envelope.volume);
  EXPECT_NEAR(area(envelope.mesh), envelope.area, 2e-3 * envelope.area);
}

// A solid in itself: points in it are enough, since one far out on each side fixes its size.
TEST(EnvelopesOfKnownSolids, SolidsHaveTheirVolumeWithinOnePercent) {
  struct Case {
    std::string name;
    Inside isInside;
    Eigen::Vector3d size;
    double volume;
    double area;
  };
  const double slope = std::sqrt(1.0 + 9.0);
  const std::vector<Case> cases = {{"ball", inBall, {1.5, 1.5, 1.5}, 4.5 * pi, 9 * pi},
                                   {"ellipsoid", inEllipsoid, sides, 4 * pi, 0},
                                   {"cylinder", inCylinder, {1, 1, 1.5}, 3 * pi, 8 * pi},
                                   {"cone", inCone, {1, 1, 1.5}, pi, pi * (1 + slope)},
                                   {"frustum", inFrustum, {1, 1, 1.5}, pi * (1 + 0.4 + 0.16), 0},
                                   {"paraboloid", inParaboloid, {1, 1, 1.5}, 1.5 * pi, 0},
                                   {"box", inBox, sides, 24, 52}};
  for (const Case& each : cases) {
    SCOPED_TRACE(each.name);
    const Envelope envelope = envelopeNamed(each.name, pointsIn(each.isInside, each.size, 100'000));
    expectWithin(envelope.volume, each.volume, 0.01);
    if (each.area > 0) expectWithin(envelope.area, each.area, 0.01);
    expectClosed(envelope);
  }
}

TEST(EnvelopesOfKnownSolids, HullsOfThemHaveTheirVolumeWithinOnePercent) {
  const std::vector<std::tuple<std::string, Inside, Eigen::Vector3d, double>> solids = {
      {"ball", inBall, {1.5, 1.5, 1.5}, 4.5 * pi},
      {"cylinder", inCylinder, {1, 1, 1.5}, 3 * pi},
      {"cone", inCone, {1, 1, 1.5}, pi},
      {"box", inBox, sides, 24},
      {"ellipsoid", inEllipsoid, sides, 4 * pi}};
  for (const auto& [name, isInside, size, volume] : solids) {
    const Eigen::Matrix3Xd points = pointsInAndOn(isInside, size, 8'000);
    for (const std::string hull : {"convex", "skinned", "extruded", "alpha"}) {
      SCOPED_TRACE(name + ", " + hull);
      const Envelope envelope = envelopeNamed(
          hull, points, UpAxis::z,
          hull == "alpha" ? std::vector<std::string>{"radius=0.5"} : std::vector<std::string>{});
      expectWithin(envelope.volume, volume, 0.01);
      expectClosed(envelope);
    }
  }
}

/// Unlike in all directions, its top and bottom beside the middle.
AsymmetricHull unlikeCrown() {
  return {.center = {0.1, -0.2},
          .azimuth = 0.4,
          .radii = {2, 1, 1.5, 1.2},
          .heights = {0.3, 0.1, -0.2, 0},
          .top = {0.3, 0.1, 2},
          .bottom = {-0.1, 0.2, -1},
          .topShape = 1.6,
          .bottomShape = 2.4};
}

TEST(EnvelopesOfKnownSolids, VolumeOfAnAsymmetricHullFollowsFromItsFormula) {
  AsymmetricHull hull; // an ellipsoid of 2, 1 and 1.5
  hull.radii = {2, 1, 2, 1};
  hull.top = {0, 0, 1.5};
  hull.bottom = {0, 0, -1.5};
  EXPECT_NEAR(volume(hull), 4 * pi, 1e-12);
  hull.topShape = 1; // a cone above
  EXPECT_NEAR(volume(hull), 2 * pi + pi, 1e-12);
  const SurfaceMesh mesh = meshOf(unlikeCrown());
  EXPECT_NEAR(volume(mesh), volume(unlikeCrown()), 2e-3 * volume(mesh));
}

TEST(EnvelopesOfKnownSolids, AnAsymmetricHullIsFoundAgain) {
  const AsymmetricHull truth = unlikeCrown();
  const SurfaceMesh mesh = meshOf(truth);
  Random random(3);
  std::vector<Eigen::Vector3d> places; // on its triangles
  for (const auto& [a, b, c] : mesh.triangles)
    for (int i = 0; i < 4; ++i) {
      const double first = std::sqrt(random.uniform());
      const double second = random.uniform();
      const auto at = [&](int corner) { return mesh.corners[static_cast<std::size_t>(corner)]; };
      places.push_back((1 - first) * at(a) + first * (1 - second) * at(b) + first * second * at(c));
    }
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = places[i];
  const Envelope envelope = envelopeNamed("asymmetric", points);
  expectWithin(envelope.volume, volume(truth), 0.01);
  EXPECT_NEAR(parameterOf(envelope, "top_shape"), 1.6, 0.1);
  EXPECT_NEAR(parameterOf(envelope, "bottom_shape"), 2.4, 0.15);
  EXPECT_NEAR(parameterOf(envelope, "top_z"), 2, 0.01);
  expectClosed(envelope);
}

// The hole of a ring stays open: a convex hull would fill it.
TEST(EnvelopesOfKnownSolids, AnAlphaHullOfARingHasItsHole) {
  Eigen::Matrix3Xd points(3, 45'000);
  points.leftCols(5'000) = pointsIn(inRing, {1.4, 1.4, 0.4}, 5'000);
  Random random(5);
  for (Eigen::Index i = 5'000; i < points.cols();) { // evenly on it: the outside is larger
    const double around = random.uniform(0, 2 * pi);
    const double across = random.uniform(0, 2 * pi);
    if (random.uniform() * 1.4 > 1 + 0.4 * std::cos(across)) continue;
    const double reach = 1 + 0.4 * std::cos(across);
    points.col(i++) =
        Eigen::Vector3d(reach * std::cos(around), reach * std::sin(around), 0.4 * std::sin(across));
  }
  const Envelope ring = envelopeNamed("alpha", points, UpAxis::z, {"radius=0.25"});
  expectWithin(ring.volume, 2 * pi * pi * 0.16, 0.01);
  EXPECT_EQ(test::topologyOf(static_cast<int>(ring.mesh.corners.size()), ring.mesh.triangles),
            (test::MeshTopology{.pieces = 1, .boundaryLoops = 0, .eulerCharacteristic = 0}));
  const double filled = 0.8 * pi + pi * pi * 0.16 + 4 * pi / 3 * 0.064; // a disk with a round rim
  expectWithin(envelopeNamed("convex", points).volume, filled, 0.01);
}

TEST(EnvelopesOfKnownSolids, HollowsWithinAreFilledUnlessToldNot) {
  const auto inShell = [](const Eigen::Vector3d& at) { return inBall(at) && at.norm() >= 1.2; };
  Eigen::Matrix3Xd shell = pointsInAndOn(inBall, {1.5, 1.5, 1.5}, 8'000);
  shell.leftCols(8'000) = pointsIn(inShell, {1.5, 1.5, 1.5}, 8'000);
  const auto filled = envelopeNamed("alpha", shell, UpAxis::z, {"radius=0.25"});
  const auto hollow = envelopeNamed("alpha", shell, UpAxis::z, {"radius=0.25", "fill=no"});
  expectWithin(filled.volume, 4.5 * pi, 0.01);
  EXPECT_LT(hollow.volume, 0.55 * filled.volume);
}

TEST(EnvelopesOfKnownSolids, ASkinnedHullIsHollowWhereASideHasNoBranches) {
  const auto inWedge = [](const Eigen::Vector3d& at) { // a quarter is missing
    return inCylinder(at) && !(at.x() > 0.05 && at.y() > 0.05 && at.head<2>().norm() > 0.3);
  };
  const Eigen::Matrix3Xd points = pointsIn(inWedge, {1, 1, 1.5}, 40'000);
  EXPECT_LT(envelopeNamed("skinned", points).volume, 0.93 * envelopeNamed("convex", points).volume);
}

TEST(EnvelopesOfKnownSolids, TurningMovingAndScalingPointsDoesSoToEachEnvelope) {
  const Eigen::Matrix3Xd points = pointsInAndOn(inEllipsoid, sides, 1'500);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d far(652'000, 5'401'000, 250);
  const Eigen::Matrix3Xd moved = (2 * turn * points).colwise() + far;
  for (const EnvelopeKind& kind : envelopeKinds()) {
    SCOPED_TRACE(kind.form.name);
    const PlantScale scale{.spacing = 0.05, .height = 3};
    const PlantScale twice{.spacing = 0.1, .height = 6};
    const Envelope first =
        envelopeAbout(points, UpAxis::z, kind, envelopeValues(kind, {}, scale, 0));
    const Envelope second =
        envelopeAbout(moved, UpAxis::z, kind, envelopeValues(kind, {}, twice, 0));
    const double share = kind.form.name == "alpha" ? 2e-3 : 1e-3; // it is drawn aside otherwise
    expectWithin(second.volume, 8 * first.volume, share);
    expectWithin(second.area, 4 * first.area, share);
    expectWithin(second.height, 2 * first.height, share);
    expectWithin(second.diameter, 2 * first.diameter, share);
  }
}

TEST(EnvelopesOfKnownSolids, UpMayBeAnyAxis) {
  const Eigen::Matrix3Xd points = pointsIn(inCone, {1, 1, 1.5}, 2'000);
  for (const UpAxis up : {UpAxis::x, UpAxis::y}) {
    const Eigen::Matrix3Xd lying = turnUpright(up).transpose() * points;
    for (const EnvelopeKind& kind : envelopeKinds()) {
      SCOPED_TRACE(kind.form.name);
      const std::vector<double> values =
          envelopeValues(kind, {}, {.spacing = 0.05, .height = 3}, 0);
      const Envelope standing = envelopeAbout(points, UpAxis::z, kind, values);
      const Envelope laid = envelopeAbout(lying, up, kind, values);
      expectWithin(laid.volume, standing.volume, 1e-6);
      expectWithin(laid.height, standing.height, 1e-6);
      Eigen::Vector3d corner = turnUpright(up) * laid.mesh.corners.front();
      EXPECT_LT((corner - standing.mesh.corners.front()).norm(), 1e-4);
    }
  }
}

TEST(EnvelopesOfKnownSolids, PlacesAmongParametersAreInTheFrameOfTheFile) {
  const Eigen::Matrix3Xd points = pointsIn(inBall, {1.5, 1.5, 1.5}, 20'000);
  const Eigen::Vector3d far(100, 200, 300);
  const Envelope ball = envelopeNamed("ball", points.colwise() + far, UpAxis::x);
  EXPECT_NEAR(parameterOf(ball, "center_x"), 100, 0.02);
  EXPECT_NEAR(parameterOf(ball, "center_y"), 200, 0.02);
  EXPECT_NEAR(parameterOf(ball, "center_z"), 300, 0.02);
  EXPECT_NEAR(parameterOf(ball, "radius"), 1.5, 0.01);
}

TEST(EnvelopesOfKnownSolids, StraysAreLeftOutByTheShareWithin) {
  Eigen::Matrix3Xd points(3, 20'010);
  points.leftCols(20'000) = pointsIn(inBall, {1.5, 1.5, 1.5}, 20'000);
  Random random(4);
  for (Eigen::Index i = 20'000; i < points.cols(); ++i)
    points.col(i) = 5 * random.direction();
  EXPECT_GT(envelopeNamed("ball", points).volume, 20 * 4.5 * pi);
  for (const EnvelopeKind& kind : envelopeKinds()) {
    SCOPED_TRACE(kind.form.name);
    const std::vector<double> values =
        envelopeValues(kind, {"within=0.99"}, {.spacing = 0.05, .height = 3}, 0);
    EXPECT_LT(envelopeAbout(points, UpAxis::z, kind, values).volume, 28.3); // of the cone
  }
}

// A ball on a stick: the crown of a tree with a bare stem.
TEST(EnvelopesOfKnownSolids, AreOfWhatIsAboveAHeightIfThatIsAsked) {
  Eigen::Matrix3Xd ball = pointsIn(inBall, {1.5, 1.5, 1.5}, 20'000);
  ball.row(2).array() += 6 - ball.row(2).minCoeff();
  Eigen::Matrix3Xd tree(3, ball.cols() + 60);
  tree.leftCols(ball.cols()) = ball;
  for (Eigen::Index i = 0; i < 60; ++i)
    tree.col(ball.cols() + i) = Eigen::Vector3d(0, 0, 0.1 * static_cast<double>(i));
  constexpr PlantScale scale{.spacing = 0.05, .height = 9};
  for (const EnvelopeKind& kind : envelopeKinds()) {
    SCOPED_TRACE(kind.form.name);
    const auto volume = [&](const Eigen::Matrix3Xd& points, const char* from) {
      return envelopeAbout(points, UpAxis::z, kind, envelopeValues(kind, {from}, scale, 0)).volume;
    };
    const double ofBall = volume(ball, "from=0");
    EXPECT_NEAR(volume(tree, "from=5.95"), ofBall, 1e-6 * ofBall);
    if (kind.form.name != "alpha") {
      EXPECT_GT(volume(tree, "from=0"), 1.2 * ofBall);
    }
    EXPECT_THAT(
        [&] { (void)volume(tree, "from=100"); },
        testing::ThrowsMessage<Error>(testing::HasSubstr("higher than \"from\", 100 above")));
  }
}

TEST(EnvelopesOfKnownSolids, PointsThatFillNoSpaceAreRefusedInOneLine) {
  Eigen::Matrix3Xd plane = pointsIn(inBox, sides, 50);
  plane.row(2).setConstant(3);
  Eigen::Matrix3Xd line(3, 10);
  for (int i = 0; i < 10; ++i)
    line.col(i) = Eigen::Vector3d(1, 2, 3) * i;
  Eigen::Matrix3Xd broken = pointsIn(inBox, sides, 50);
  broken(1, 7) = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Eigen::Matrix3Xd> hostile = {Eigen::Matrix3Xd(3, 0),
                                                 Eigen::Matrix3Xd::Zero(3, 3),
                                                 Eigen::Matrix3Xd::Ones(3, 100),
                                                 plane,
                                                 line,
                                                 broken};
  for (const EnvelopeKind& kind : envelopeKinds())
    for (const Eigen::Matrix3Xd& points : hostile) {
      const std::vector<double> values = envelopeValues(kind, {}, {.spacing = 1, .height = 1}, 0);
      try {
        (void)envelopeAbout(points, UpAxis::z, kind, values);
        ADD_FAILURE() << kind.form.name << " took " << points.cols() << " points";
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("envelope"), std::string::npos) << error.what();
      }
    }
}

// The corners of a box, and of an octahedron: few points, five and more on one ball.
TEST(EnvelopesOfKnownSolids, FewPointsAreEnough) {
  Eigen::Matrix3Xd cube(3, 8);
  for (int i = 0; i < 8; ++i)
    cube.col(i) = Eigen::Vector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  for (const EnvelopeKind& kind : envelopeKinds()) {
    SCOPED_TRACE(kind.form.name);
    const Envelope envelope = envelopeAbout(
        cube, UpAxis::z, kind, envelopeValues(kind, {}, {.spacing = 1, .height = 30}, 0));
    EXPECT_GT(envelope.volume, 0.3);
    EXPECT_LT(envelope.volume, 9.1); // of the cone: 3 high, over a circle of 1.06
  }
  EXPECT_NEAR(envelopeNamed("box", cube).volume, 1, 1e-9);
  EXPECT_NEAR(envelopeNamed("convex", cube).volume, 1, 1e-9);
  EXPECT_NEAR(envelopeNamed("extruded", cube).volume, 1, 1e-9);
  EXPECT_NEAR(envelopeNamed("ball", cube).volume, pi * std::sqrt(3.0) / 2, 1e-9);
  EXPECT_NEAR(envelopeNamed("alpha", cube, UpAxis::z, {"radius=2"}).volume, 1, 1e-3);
}

TEST(EnvelopesOfKnownSolids, ABallThatPassesBetweenAllPointsMakesNoBody) {
  const Eigen::Matrix3Xd points = pointsIn(inBox, sides, 100);
  EXPECT_THROW((void)envelopeNamed("alpha", points, UpAxis::z, {"radius=0.03"}), Error);
}

TEST(EnvelopesOfKnownSolids, AStoppedProgressEndsEachKind) {
  const Eigen::Matrix3Xd points = pointsIn(inBall, {1.5, 1.5, 1.5}, 3'000);
  std::stop_source stop;
  stop.request_stop();
  const Progress stopped(stop.get_token(), nullptr);
  for (const EnvelopeKind& kind : envelopeKinds())
    EXPECT_THROW((void)envelopeAbout(points, UpAxis::z, kind,
                                     envelopeValues(kind, {}, {.spacing = 0.1, .height = 3}, 0),
                                     stopped),
                 Cancelled)
        << kind.form.name;
}

TEST(EnvelopesOfKnownSolids, OptionsThatAreNoneAreNamed) {
  const auto message = [](const std::string& kind, const std::string& setting) {
    try {
      (void)envelopeValues(envelopeKindNamed(kind), {setting}, {.spacing = 1, .height = 1}, 0);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("alpha", "radios=3"),
            "envelope alpha has no option \"radios\": choose one of within, from, radius, fill");
  EXPECT_EQ(message("ball", "within"),
            "\"within\" sets nothing: write OPTION=VALUE, with one of within, from");
  EXPECT_EQ(message("skinned", "profiles=2"),
            "envelope.profiles is 2: choose a whole number from 3 to 72");
  EXPECT_THROW((void)envelopeKindNamed("egg"), Error);
}

} // namespace
} // namespace espalier
