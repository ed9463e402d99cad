#pragma once

#include "core/cloud/joined_clouds.h"
#include "core/io/formats.h"
#include "tests/app/window/project_fixture.h"

#include <QLabel>
#include <QTableWidget>

#include <algorithm>
#include <numbers>

namespace espalier::test {

using Eigen::Vector3d;

/// The scan of a plant, north.xyz, and the same again from a frame of its own, south.ply.
struct RegistrationTest : ProjectWindowTest {
  const QString north_ = writeScan("north.xyz");
  const QString south_ = path("south.ply");
  const Eigen::Isometry3d truth_ =
      Eigen::Translation3d(0.06, -0.05, 0.04) *
      Eigen::AngleAxisd(3 * std::numbers::pi / 180, Vector3d::UnitZ()) *
      Eigen::Isometry3d::Identity();
  /// Where branches end.
  const std::vector<Vector3d> targets_ = {
      {0.8, 0, 1.6}, {-0.7, 0.1, 1.9}, {0.1, 0.7, 1.3}, {0, 0, 0.1}};

  RegistrationTest() { writeSouth(); }

  void writeSouth() {
    const auto cloud = std::make_shared<const PointCloud>(readPoints(toPath(north_)).value);
    writePoints(toPath(south_),
                joined({{.cloud = cloud, .motion = truth_.inverse(), .name = "south"}}));
  }

  void begin() {
    open({north_});
    document().setUnit(LengthUnit::meter);
    beginAgain();
  }
  void beginAgain() {
    answer(chooseFile(south_), [this] { action("register_scan").trigger(); });
    waitForJob();
    waitForView();
  }
  [[nodiscard]] const PointCloud& cloud() { return *document().scan()->cloud(); }
  void clickPlace(const Vector3d& place) {
    const QPointF at = view().project(place).value();
    hover(at.toPoint());
    click(at.toPoint());
  }
  /// Clicks a target in the open scan, then in the other one, which lies as it was read.
  void pickPair(std::size_t target) {
    clickPlace(targets_[target]);
    clickPlace(truth_.inverse() * targets_[target]);
  }
  void pickThree() {
    for (const std::size_t target : {0, 1, 2})
      pickPair(target);
  }
  void fit() {
    action("fit_scan").trigger();
    waitForJob();
  }
  void join(const QString& name) {
    answer(chooseFile(path(name)), [this] { action("join_scans").trigger(); });
    waitForJob();
  }
  [[nodiscard]] QString next() { return find<QLabel>("registration_next").text(); }
  [[nodiscard]] QTableWidget& pairs() { return find<QTableWidget>("registration_pairs"); }
  /// How far what was joined lies from where it belongs, at most [L].
  [[nodiscard]] double farthestOff() {
    const Eigen::Index half = cloud().size() / 2;
    const PointCloud moved = readPoints(toPath(south_)).value;
    const SpatialIndex index(moved.positions());
    double farthest = 0;
    for (Eigen::Index i = half; i < cloud().size(); ++i) {
      const Vector3d place = truth_.inverse() * cloud().position(i) - moved.origin();
      const auto nearest = index.nearestOne(place.cast<float>());
      farthest = std::max(
          farthest, double((moved.positions().col(nearest->index) - place.cast<float>()).norm()));
    }
    return farthest;
  }
};

} // namespace espalier::test
