// Twenty mistakes are put into an expert's structure and mended over the scan, all by mouse and key
// events in the real window. All that the hand did is counted by kind: each key, click, drag and
// run of the wheel, whether it edits or looks. Mistakes lie where they are seen after a turn of the
// plant and a zoom: none is behind wood from all sides. Where they lie is known; to find them is
// the work of the findings list and the review.
#include "app/window/frame/action_set.h"
#include "core/base/random.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/shared_data.h"

#include <QAction>
#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <iostream>
#include <limits>
#include <map>
#include <set>

namespace espalier {
namespace {

double distanceTo(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector3d step = line[i] - line[i - 1];
    const double along = std::clamp((place - line[i - 1]).dot(step) / step.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (line[i - 1] + along * step - place).norm());
  }
  return nearest;
}

class CorrectionTest : public test::WindowTest {
protected:
  /// A branch that is, or was, attached to `parent`.
  struct Mistake {
    NodeId branch;
    NodeId parent;                       // where it belongs
    Node node;                           // as it was
    std::vector<Eigen::Vector3d> places; // of the branch, from its first node to its tip
  };

  void did(const std::string& gesture) { ++gestures_[gesture]; }
  [[nodiscard]] int gestures() const {
    int sum = 0;
    for (const auto& [name, count] : gestures_)
      sum += count;
    return sum;
  }

  [[nodiscard]] std::optional<QPoint> seen(NodeId id) {
    const auto place = view().project(document().skeleton()[id].position);
    if (!place || !view().rect().adjusted(8, 8, -8, -8).contains(place->toPoint())) return {};
    const QPoint pixel = place->toPoint(); // where the mouse can be
    return view().pick(pixel).node == id ? std::optional(pixel) : std::nullopt;
  }
  [[nodiscard]] std::optional<QPoint> seen(const Eigen::Vector3d& place, double within) {
    const auto at = view().project(place);
    if (!at || !view().rect().adjusted(8, 8, -8, -8).contains(at->toPoint())) return {};
    const Pick pick = view().pick(*at);
    const bool isThere = !pick.node && pick.point && (*pick.point - place).norm() < within;
    return isThere ? std::optional(at->toPoint()) : std::nullopt;
  }

  /// Is a part of the plant seen from any side? Shows all, turns, and zooms there.
  bool isSeenFromSomewhere(const Eigen::Vector3d& place, double size,
                           const std::function<bool()>& isSeen) {
    for (int turns = 0; turns < 6; ++turns) {
      key(Qt::Key_Home);
      waitForView();
      for (int i = 0; i < turns; ++i)
        turn(view(), 160);
      zoomTo(place, size);
      if (isSeen()) return true;
    }
    return false;
  }

  /// Makes `size` [L] at the place a fifth of the view.
  void zoomTo(const Eigen::Vector3d& place, double size) {
    for (int ticks = 0; ticks < 40; ++ticks) {
      const auto at = view().project(place);
      const auto beside = view().project(place + size * view().camera().up());
      if (!at || !beside || std::abs(beside->y() - at->y()) > view().height() / 5.0) return;
      wheel(view(), *at, 120);
    }
  }

  static void turn(PlantView& in, int pixels) {
    turnUntil(in, pixels, [] { return false; });
  }
  /// Turns by as many pixels in one drag, or less if it is `done`.
  static bool turnUntil(PlantView& in, int pixels, const std::function<bool()>& done) {
    QPoint at(in.width() / 2, in.height() / 2);
    QTest::mousePress(&in, Qt::LeftButton, Qt::ControlModifier, at);
    bool isDone = false;
    for (const int end = at.x() + pixels; at.x() < end && !isDone;) {
      at.rx() += std::min(40, end - at.x());
      QMouseEvent move(QEvent::MouseMove, QPointF(at), QPointF(in.mapToGlobal(at)), Qt::NoButton,
                       Qt::LeftButton, Qt::ControlModifier);
      QApplication::sendEvent(&in, &move);
      isDone = done();
    }
    QTest::mouseRelease(&in, Qt::LeftButton, Qt::ControlModifier, at);
    return isDone;
  }

  [[nodiscard]] PlantView& whole() { return find<PlantView>("second_view"); }
  void showWhole() {
    key(Qt::Key_F12);
    did("look: two views (F12)");
    action("link_whole").trigger();
    for (const char* menu : {"View", "Second View", "All of the Plant"})
      did(std::string("look: menu, ") + menu + " (click)");
    QEvent leave(QEvent::Leave); // the pointer is on the menu: what it was on is not meant any more
    QApplication::sendEvent(&view(), &leave);
    waitForViews();
  }
  void waitForViews() {
    waitForView();
    ASSERT_TRUE(QTest::qWaitFor([&] { return whole().isStill(); }, patience));
  }

  /// What one means to point at: places along it, and whether a pick is it.
  struct Aim {
    std::vector<Eigen::Vector3d> places;
    std::function<bool(const Pick&)> isIt;
  };

  /// Points in the view of all of the plant at what is meant, or at what is near it, and looks
  /// closely; turns that view first if it is hidden there.
  bool lookClosely(const Aim& meant, const std::function<bool()>& isSeen) {
    constexpr int round = 900; // pixels that turn a view once around and more
    if (!pointAt(meant)) {
      did("look: turn all of the plant (drag)");
      if (!turnUntil(whole(), round, [&] { return pointAt(meant).has_value(); })) return false;
      waitForViews();
    }
    const std::optional<QPoint> at = pointAt(meant);
    if (!at) return false;
    QMouseEvent move(QEvent::MouseMove, QPointF(*at), QPointF(whole().mapToGlobal(*at)),
                     Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&whole(), &move);
    key(Qt::Key_Z);
    did("look: closely (Z)");
    waitForViews();
    if (isSeen()) return true;
    did("look: zoom out (wheel)");
    for (int ticks = 0; ticks < 8; ++ticks) {
      wheel(view(), view().rect().center(), -120);
      if (isSeen()) return true;
    }
    did("look: turn (drag)");
    return turnUntil(view(), round, isSeen);
  }

  [[nodiscard]] std::optional<QPoint> pointAt(const Aim& meant) {
    constexpr double near = 150; // [mm], of what Look Closely shows around
    std::optional<QPoint> beside;
    for (const Eigen::Vector3d& place : meant.places) {
      const auto at = whole().project(place);
      if (!at) continue;
      const Pick pick = whole().pick(at->toPoint());
      if (meant.isIt(pick)) return at->toPoint();
      std::optional<Eigen::Vector3d> on = pick.point;
      if (pick.edge) on = pick.edge->position;
      if (pick.node) on = this->place(*pick.node);
      if (on && !beside && (*on - place).norm() < near) beside = at->toPoint();
    }
    return beside;
  }

  static void wheel(PlantView& in, const QPointF& at, int angle) {
    QWheelEvent event(at, in.mapToGlobal(at), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&in, &event);
  }

  /// Draws along these places with Shift and Alt.
  void stroke(const std::vector<Eigen::Vector3d>& places) {
    const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButtons buttons) {
      QMouseEvent event(type, QPointF(at), QPointF(view().mapToGlobal(at)),
                        type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons,
                        Qt::ShiftModifier | Qt::AltModifier);
      QApplication::sendEvent(&view(), &event);
    };
    std::vector<QPoint> pixels;
    for (const Eigen::Vector3d& at : places)
      pixels.push_back(view().project(at)->toPoint());
    hover(pixels.front());
    send(QEvent::MouseButtonPress, pixels.front(), Qt::LeftButton);
    for (std::size_t i = 1; i < pixels.size(); ++i)
      for (int step = 1; step <= 6; ++step)
        send(QEvent::MouseMove, pixels[i - 1] + (pixels[i] - pixels[i - 1]) * step / 6,
             Qt::LeftButton);
    send(QEvent::MouseButtonRelease, pixels.back(), Qt::NoButton);
  }

  [[nodiscard]] Eigen::Vector3d place(NodeId id) { return document().skeleton()[id].position; }

  /// Attaches a branch to a node of another axis nearby; none if there is none.
  std::optional<Mistake> attachWrongly(NodeId branch) {
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
    const Eigen::Vector3d from = place(*document().skeleton()[mistake.branch].parent);
    const Eigen::Vector3d to = place(mistake.branch);
    const auto isSeen = [&] { return seen(mistake.branch) && seen(mistake.parent); };
    Aim edge{.places = {}, .isIt = [&](const Pick& pick) {
               return pick.node == mistake.branch ||
                      (pick.edge && pick.edge->child == mistake.branch);
             }};
    for (const double share : {0.5, 0.75, 0.25, 0.9, 0.1})
      edge.places.emplace_back(from + share * (to - from));
    ASSERT_TRUE(lookClosely(edge, isSeen));
    drag(*seen(mistake.branch), *seen(mistake.parent));
    did("reparent (drag)");
  }

  void mendSpur(NodeId spur) {
    const Eigen::Vector3d at = place(spur);
    const NodeId tip = document().skeleton().children(spur).front();
    const Aim meant{
        .places = {at, (at + place(tip)) / 2, place(tip)}, .isIt = [&](const Pick& pick) {
          const NodeId under = pick.edge ? pick.edge->child : pick.node.value_or(NodeId{0});
          return under == spur || under == tip;
        }};
    ASSERT_TRUE(lookClosely(meant, [&] { return seen(spur).has_value(); }));
    hover(*seen(spur));
    key(Qt::Key_Delete, Qt::ShiftModifier);
    did("remove subtree (Shift+Del)");
  }

  void mendMissing(const Mistake& mistake) {
    const std::vector<Eigen::Vector3d>& places = mistake.places;
    const Aim points{.places = places, .isIt = [&](const Pick& pick) {
                       return !pick.node && !pick.edge && pick.point &&
                              distanceTo(places, *pick.point) < 25;
                     }};
    const auto isSeen = [&] { return seen(mistake.parent) && seen(places.back(), 25); };
    ASSERT_TRUE(lookClosely(points, isSeen));
    std::vector<Eigen::Vector3d> branchPath = {place(mistake.parent)};
    branchPath.insert(branchPath.end(), places.begin(), places.end());
    const std::size_t before = document().skeleton().size();
    const std::size_t firstNew = document().skeleton().idEnd();
    stroke(branchPath);
    did("stroke a branch (Shift+Alt+drag)");
    const auto isThere = [&] { return document().skeleton().size() > before; };
    ASSERT_TRUE(QTest::qWaitFor(isThere, patience));
    if (isRight(mistake, firstNew)) return;
    key(Qt::Key_Z, Qt::ControlModifier);
    did("undo (Ctrl+Z)");
    trace(*seen(mistake.parent), *seen(places.back(), 25));
  }

  /// Is it seen that the new branch leads from its parent to its tip, along its wood?
  [[nodiscard]] bool isRight(const Mistake& mistake, std::size_t firstNew) {
    std::vector<Eigen::Vector3d> wood = {place(mistake.parent)};
    wood.insert(wood.end(), mistake.places.begin(), mistake.places.end());
    bool isAtTip = false;
    for (const NodeId id : downstream(document().skeleton(), {mistake.parent})) {
      if (indexOf(id) < firstNew) continue;
      if (distanceTo(wood, place(id)) > 20) return false;
      isAtTip = isAtTip || (place(id) - wood.back()).norm() < 30;
    }
    return isAtTip;
  }

  void trace(const QPoint& from, const QPoint& to) {
    key(Qt::Key_L);
    did("choose a tool (L)");
    click(from);
    did("trace: start (click)");
    click(to);
    did("trace: end (click)");
    const QAction& accept = action("accept");
    ASSERT_TRUE(QTest::qWaitFor([&] { return accept.isEnabled(); }, patience));
    key(Qt::Key_Return);
    did("trace: accept (Enter)");
    key(Qt::Key_Y);
    did("choose a tool (Y)");
  }

  std::map<std::string, int> gestures_;
};

TEST_F(CorrectionTest, MendsTwentyMistakesInAnExpertsStructure) {
  ESPALIER_SHARED_FILE(scan, "puu1/scan.ply");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  open({QString::fromStdString(scan.string()), QString::fromStdString(expert.string())});
  const Skeleton truth = document().skeleton();
  window().resize(1288, 800); // which mistakes are seen, and so are made, depends on the view

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
      if (const auto mistake = attachWrongly(id)) {
        const Eigen::Vector3d middle = (place(id) + place(mistake->parent)) / 2;
        const double size = (place(id) - place(mistake->parent)).norm();
        isSeen =
            isSeenFromSomewhere(middle, size, [&] { return seen(id) && seen(mistake->parent); });
        if (isSeen) wrong.push_back(*mistake);
        touched.insert(mistake->parent);
      }
    } else if (missing.size() < 5) {
      if (const auto mistake = takeAway(id)) {
        const Eigen::Vector3d tip = mistake->places.back();
        const double size = (tip - place(mistake->parent)).norm();
        isSeen = isSeenFromSomewhere((tip + place(mistake->parent)) / 2, size,
                                     [&] { return seen(mistake->parent) && seen(tip, 25); });
        if (isSeen) missing.push_back(*mistake);
        touched.insert(mistake->parent);
      }
    } else {
      const NodeId spur = addSpur(id, random.direction());
      isSeen = isSeenFromSomewhere(place(spur), 60, [&] { return seen(spur).has_value(); });
      if (isSeen) spurs.push_back(spur);
      touched.insert(id);
    }
    touched.insert(carried.begin(), carried.end());
    if (!isSeen && document().undoStack().count() > steps) document().undoStack().undo();
  }
  ASSERT_EQ(wrong.size() + missing.size() + spurs.size(), 20U);
  showWhole();
  key(Qt::Key_P);
  did("choose a tool (P)");
  for (const Mistake& mistake : wrong)
    mendParent(mistake);
  key(Qt::Key_Escape);
  did("leave the tool (Esc)");
  for (const NodeId spur : spurs)
    mendSpur(spur);
  key(Qt::Key_Y);
  did("choose a tool (Y)");
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
  // A branch begins where its points leave the bearer, be it at the node before or after.
  constexpr double edge = 45; // [mm], the median
  const auto beginsAt = [&](NodeId id, const Mistake& mistake) {
    while (!truth.contains(id))
      id = *mended[id].parent;
    return (place(id) - place(mistake.parent)).norm() < edge;
  };
  for (const Mistake& mistake : missing) {
    std::vector<Eigen::Vector3d> places = {place(mistake.parent)};
    places.insert(places.end(), mistake.places.begin(), mistake.places.end());
    double toTip = std::numeric_limits<double>::infinity();
    for (const NodeId id : mended.ids()) {
      if (truth.contains(id) || !beginsAt(id, mistake)) continue;
      toTip = std::min(toTip, (place(id) - mistake.places.back()).norm());
      EXPECT_LT(distanceTo(places, place(id)), 2 * edge) << indexOf(id);
    }
    EXPECT_LT(toTip, 30) << indexOf(mistake.branch);
  }
  for (const NodeId id : mended.ids())
    EXPECT_TRUE(
        truth.contains(id) ||
        std::ranges::any_of(missing, [&](const Mistake& mistake) { return beginsAt(id, mistake); }))
        << "left over: " << indexOf(id);

  std::cout << gestures() << " gestures\n";
  for (const auto& [name, count] : gestures_)
    std::cout << "  " << count << "  " << name << '\n';
  EXPECT_LT(gestures(), 3 * 20) << "all that the hand did";
  RecordProperty("gestures", gestures());
}

} // namespace
} // namespace espalier
