#pragma once

#include "tests/app/window/project_fixture.h"

#include <QComboBox>
#include <QLabel>
#include <QTest>
#include <QTreeView>

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier::test {

/// The fork, into which mistakes are put.
struct FindingsWindowTest : ProjectWindowTest {
  static constexpr auto allIsWell = "Nothing to look at: all checks pass";

  void openFork() { open({writeFork("fork.mtg")}); }
  void openForkAndScan() { open({writeScan("plant.xyz"), writeFork("fork.mtg")}); }

  NodeId shoot(int number) {
    const double angle = 2 * M_PI * number / 3;
    return nodeAt({std::cos(angle), std::sin(angle), 2});
  }
  void setRadiusOf(NodeId id, double radius) {
    document().edit("Radius", [=](SkeletonEditor& editor) { editor.setRadius(id, radius); });
  }

  QTreeView& list() { return find<QTreeView>("findings_list"); }
  QModelIndex row(int number) { return list().model()->index(number, 0); }
  QPoint placeOfRow(int number) { return list().visualRect(row(number)).center(); }
  QString title() { return find<QLabel>("findings_title").text(); }
  [[nodiscard]] bool waitForTitle(const QString& text) {
    return QTest::qWaitFor([&] { return title() == text; }, patience);
  }
  /// The number that is written behind a kind; empty where there are none of it.
  QString countOf(const QString& kind) {
    const int at = placeOfKind(kind);
    return at < 0 ? QString() : kinds().itemText(at).section('(', 1).chopped(1);
  }
  void chooseKind(const QString& kind) {
    const int at = placeOfKind(kind);
    ASSERT_GE(at, 0) << kind.toStdString();
    kinds().setCurrentIndex(at);
    emit kinds().activated(at);
  }
  QComboBox& kinds() { return find<QComboBox>("findings_kind"); }
  int placeOfKind(const QString& kind) {
    return kinds().findText(kind + " (", Qt::MatchStartsWith);
  }
  std::vector<NodeId> chosen() { return document().selection().nodes(); }
  bool isDrawn(NodeId id) {
    return std::ranges::count(view().nodesInside(QRectF(view().rect()), Depth::through), id) > 0;
  }
  bool isSeen(const Eigen::Vector3d& place) {
    const auto shown = view().project(place);
    return shown && view().rect().contains(shown->toPoint());
  }
};

} // namespace espalier::test
