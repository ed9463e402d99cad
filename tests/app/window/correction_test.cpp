// Twenty mistakes are put into an expert's structure and mended over the scan, all by mouse and key
// events in the real window. What the hand did is counted by kind. Mistakes lie where they are seen
// after a turn of the plant and a zoom: none is behind wood from all sides.
#include "app/window/action_set.h"
#include "core/base/random.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/shared_data.h"

#include <QAction>
#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <iostream>
#include <limits>
#include <map>
#include <set>

namespace espalier {
namespace {

constexpr int patience = 60'000; // ms; a deadline for what would else hang

class CorrectionTest : public test::WindowTest {
protected:
  /// A branch that hangs, or hung, on `parent`.
  struct Mistake {
    NodeId branch;
    NodeId parent;                       // where it belongs
    Node node;                           // as it was
    std::vector<Eigen::Vector3d> places; // of the branch, from its first node to its tip
  };

  void did(const std::string& gesture) { ++gestures_[gesture]; }
  int gestures(bool isEdit) const {
    int sum = 0;
    for (const auto& [name, count] : gestures_)
      if (name.starts_with("look: ") != isEdit) sum += count;
    return sum;
  }

  [[nodiscard]] std::optional<QPoint> seen(NodeId id) {
    const auto place = view().project(document().skeleton()[id].position);
    if (!place || !view().rect().adjusted(8, 8, -8, -8).contains(place->toPoint())) return {};
    return view().pick(*place).node == id ? std::optional(place->toPoint()) : std::nullopt;
  }
  [[nodiscard]] std::optional<QPoint> seen(const Eigen::Vector3d& place, double within) {
    const auto at = view().project(place);
    if (!at || !view().rect().adjusted(8, 8, -8, -8).contains(at->toPoint())) return {};
    const Pick pick = view().pick(*at);
    const bool isThere = !pick.node && pick.point && (*pick.point - place).norm() < within;
    return isThere ? std::optional(at->toPoint()) : std::nullopt;
  }

  /// Brings a part of the plant near as a hand does, until `isSeen`: shows all, turns, zooms there.
  bool lookAt(const Eigen::Vector3d& place, double size, const std::function<bool()>& isSeen) {
    for (int turns = 0; turns < 6; ++turns) {
      key(Qt::Key_Home);
      waitForView();
      for (int i = 0; i < turns; ++i)
        turn(160);
      zoomTo(place, size);
      if (!isSeen()) continue; // one who sees the plant turns it at once to where it shows
      did("look: show all (Home)");
      if (turns > 0) did("look: turn (drag)");
      did("look: zoom (wheel)");
      return true;
    }
    return false;
  }

  /// Makes `size` [L] at the place a fifth of the view.
  void zoomTo(const Eigen::Vector3d& place, double size) {
    for (int ticks = 0; ticks < 40; ++ticks) {
      const auto at = view().project(place);
      const auto beside = view().project(place + size * view().camera().up());
      if (!at || !beside || std::abs(beside->y() - at->y()) > view().height() / 5.0) return;
      QWheelEvent wheel(*at, view().mapToGlobal(*at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(&view(), &wheel);
    }
  }

  void turn(int pixels) {
    const QPoint from(view().width() / 2, view().height() / 2);
    QTest::mousePress(&view(), Qt::LeftButton, Qt::ControlModifier, from);
    QTest::mouseMove(&view(), from + QPoint(pixels / 2, 0));
    QTest::mouseMove(&view(), from + QPoint(pixels, 0));
    QTest::mouseRelease(&view(), Qt::LeftButton, Qt::ControlModifier, from + QPoint(pixels, 0));
  }

  [[nodiscard]] Eigen::Vector3d place(NodeId id) { return document().skeleton()[id].position; }

  /// Hangs a branch on a node of another axis nearby; none if there is none.
  std::optional<Mistake> hangWrong(NodeId branch) {
    const Skeleton& plant = document().skeleton();
    const Node node = plant[branch];
    if (!node.parent || node.edge != EdgeType::branching) return {};
    const NodeId parent = *node.parent;
    const std::vector<NodeId>& siblings = plant.children(parent);
    if (siblings.empty() || plant[siblings.front()].edge != EdgeType::successor) return {};
    std::optional<NodeId> wrong;
    double nearest = 400; // mm
    for (const NodeId id : plant.ids()) {
      const double distance = (plant[id].position - node.position).norm();
      if (distance > nearest || plant.isAncestor(branch, id) || plant.isAncestor(id, parent) ||
          plant.isAncestor(parent, id))
        continue;
      nearest = distance;
      wrong = id;
    }
    if (!wrong) return {};
    document().edit("Mistake",
                    [&](SkeletonEditor& editor) { reparentNode(editor, branch, *wrong); });
    return Mistake{branch, parent, node, {}};
  }

  /// Takes a twig of some length away of which the scan has points up to its tip.
  std::optional<Mistake> takeAway(NodeId branch) {
    const Skeleton& plant = document().skeleton();
    const Node node = plant[branch];
    if (!node.parent || node.edge != EdgeType::branching) return {};
    std::vector<Eigen::Vector3d> places = {node.position};
    double length = 0;
    NodeId tip = branch;
    while (plant.children(tip).size() == 1) {
      tip = plant.children(tip).front();
      length += (plant[tip].position - places.back()).norm();
      places.push_back(plant[tip].position);
    }
    if (!plant.children(tip).empty() || length < 60 || length > 400) return {};
    document().edit("Mistake", [&](SkeletonEditor& editor) { removeSubtree(editor, branch); });
    return Mistake{branch, *node.parent, node, places};
  }

  /// Lets a spur of two nodes stand out where there is no wood.
  NodeId addSpur(NodeId on, const Eigen::Vector3d& direction) {
    NodeId spur{};
    document().edit("Mistake", [&](SkeletonEditor& editor) {
      spur = addChild(editor, on, place(on) + 30 * direction);
      addChild(editor, spur, place(on) + 60 * direction);
    });
    return spur;
  }

  void mendParent(const Mistake& mistake) {
    const Eigen::Vector3d middle = (place(mistake.branch) + place(mistake.parent)) / 2;
    const double size = (place(mistake.branch) - place(mistake.parent)).norm();
    ASSERT_TRUE(lookAt(middle, size, [&] { return seen(mistake.branch) && seen(mistake.parent); }));
    drag(*seen(mistake.branch), *seen(mistake.parent));
    did("reparent (drag)");
  }

  void mendSpur(NodeId spur) {
    ASSERT_TRUE(lookAt(place(spur), 60, [&] { return seen(spur).has_value(); }));
    hover(*seen(spur));
    key(Qt::Key_Delete, Qt::ShiftModifier);
    did("remove subtree (Shift+Del)");
  }

  void mendMissing(const Mistake& mistake) {
    const Eigen::Vector3d tip = mistake.places.back();
    const double size = (tip - place(mistake.parent)).norm();
    const Eigen::Vector3d middle = (tip + place(mistake.parent)) / 2;
    ASSERT_TRUE(lookAt(middle, size, [&] { return seen(mistake.parent) && seen(tip, 25); }));
    const QPoint from = *seen(mistake.parent);
    const QPoint to = *seen(tip, 25);
    click(from);
    did("trace: start (click)");
    click(to);
    did("trace: end (click)");
    const QAction& accept = action("accept");
    ASSERT_TRUE(QTest::qWaitFor([&] { return accept.isEnabled(); }, patience));
    key(Qt::Key_Return);
    did("trace: accept (Enter)");
  }

  std::map<std::string, int> gestures_;
};

double distanceTo(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector3d way = line[i] - line[i - 1];
    const double along = std::clamp((place - line[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (line[i - 1] + along * way - place).norm());
  }
  return nearest;
}

TEST_F(CorrectionTest, MendsTwentyMistakesInAnExpertsStructure) {
  ESPALIER_SHARED_FILE(scan, "puu1/scan.ply");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  open({QString::fromStdString(scan.string()), QString::fromStdString(expert.string())});
  const Skeleton truth = document().skeleton();

  Random random(2012);
  std::vector<NodeId> candidates = truth.ids();
  for (std::size_t i = candidates.size(); i > 1; --i)
    std::swap(candidates[i - 1], candidates[random.below(i)]);
  std::vector<Mistake> wrong;
  std::vector<Mistake> missing;
  std::vector<NodeId> spurs;
  std::set<NodeId> touched; // mistakes lie apart: none hides another
  for (const NodeId id : candidates) {
    if (wrong.size() == 10 && missing.size() == 5 && spurs.size() == 5) break;
    if (!document().skeleton().contains(id) || touched.contains(id)) continue;
    const std::vector<NodeId> carried = downstream(document().skeleton(), {id});
    if (carried.size() > 40) continue;
    if (std::ranges::any_of(carried, [&](NodeId node) { return touched.contains(node); })) continue;
    const int steps = document().undoStack().count();
    bool isSeen = false;
    if (wrong.size() < 10) {
      if (const auto mistake = hangWrong(id)) {
        const Eigen::Vector3d middle = (place(id) + place(mistake->parent)) / 2;
        const double size = (place(id) - place(mistake->parent)).norm();
        isSeen = lookAt(middle, size, [&] { return seen(id) && seen(mistake->parent); });
        if (isSeen) wrong.push_back(*mistake);
        touched.insert(mistake->parent);
      }
    } else if (missing.size() < 5) {
      if (const auto mistake = takeAway(id)) {
        const Eigen::Vector3d tip = mistake->places.back();
        const double size = (tip - place(mistake->parent)).norm();
        isSeen = lookAt((tip + place(mistake->parent)) / 2, size,
                        [&] { return seen(mistake->parent) && seen(tip, 25); });
        if (isSeen) missing.push_back(*mistake);
        touched.insert(mistake->parent);
      }
    } else {
      const NodeId spur = addSpur(id, random.direction());
      isSeen = lookAt(place(spur), 60, [&] { return seen(spur).has_value(); });
      if (isSeen) spurs.push_back(spur);
      touched.insert(id);
    }
    touched.insert(carried.begin(), carried.end());
    if (!isSeen && document().undoStack().count() > steps) document().undoStack().undo();
  }
  ASSERT_EQ(wrong.size() + missing.size() + spurs.size(), 20U);
  gestures_.clear();

  key(Qt::Key_P);
  did("choose a tool (P)");
  for (const Mistake& mistake : wrong)
    mendParent(mistake);
  key(Qt::Key_Escape);
  for (const NodeId spur : spurs)
    mendSpur(spur);
  key(Qt::Key_Escape);
  key(Qt::Key_L);
  did("choose a tool (L)");
  for (const Mistake& mistake : missing)
    mendMissing(mistake);

  const Skeleton& mended = document().skeleton();
  std::set<NodeId> gone; // with the branches taken away: they have new nodes now
  for (const NodeId id : truth.ids())
    if (!mended.contains(id)) gone.insert(id);
  for (const NodeId id : truth.ids()) {
    if (gone.contains(id)) continue;
    EXPECT_EQ(mended[id].parent, truth[id].parent) << indexOf(id);
    EXPECT_EQ(mended[id].position, truth[id].position) << indexOf(id);
    EXPECT_TRUE(!truth[id].parent || mended[id].edge == truth[id].edge) << indexOf(id);
  }
  for (const Mistake& mistake : missing) {
    std::vector<Eigen::Vector3d> places = {place(mistake.parent)};
    places.insert(places.end(), mistake.places.begin(), mistake.places.end());
    double toTip = std::numeric_limits<double>::infinity();
    for (const NodeId id : downstream(mended, {mistake.parent})) {
      if (truth.contains(id)) continue;
      toTip = std::min(toTip, (place(id) - mistake.places.back()).norm());
    }
    EXPECT_LT(toTip, 30) << indexOf(mistake.branch);
    for (const NodeId child : mended.children(mistake.parent))
      EXPECT_TRUE(truth.contains(child) || distanceTo(places, place(child)) < 20);
  }
  for (const NodeId id : mended.ids()) {
    const bool isMissing = std::ranges::any_of(
        missing, [&](const Mistake& mistake) { return mended.isAncestor(mistake.parent, id); });
    EXPECT_TRUE(truth.contains(id) || isMissing) << "left over: " << indexOf(id);
  }

  for (const auto& [name, count] : gestures_)
    std::cout << "  " << count << "  " << name << '\n';
  EXPECT_LT(gestures(true), 3 * 20) << "edits by hand";
  RecordProperty("edits_by_hand", gestures(true));
  RecordProperty("looks", gestures(false));
}

} // namespace
} // namespace espalier
