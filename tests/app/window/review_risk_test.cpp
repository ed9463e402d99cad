// The walk of the review over a scan: clean wood whole, risky wood closer, points without wood.
#include "app/window/files/load_files.h"
#include "core/io/formats.h"
#include "core/skeleton/review_stops.h"
#include "tests/app/window/review_fixture.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QFile>
#include <QTextStream>

#include <algorithm>
#include <cmath>
#include <optional>

namespace espalier {
namespace {

/// A straight stem of 2 with its scan, a twig that no point is near, and a lump of points that no
/// wood is near.
struct ReviewByRiskTest : test::ReviewWindowTest {
  ReviewByRiskTest() {
    QFile scan(path("scan.xyz"));
    if (!scan.open(QIODevice::WriteOnly)) return;
    QTextStream text(&scan);
    const auto add = [&](double x, double y, double z) {
      text << x << ' ' << y << ' ' << z << '\n';
    };
    for (int i = 0; i < 400; ++i) // around the stem, every 5 mm
      for (int k = 0; k < 12; ++k)
        add(0.02 * std::cos(k * 0.5236 + 0.1 * i), 0.02 * std::sin(k * 0.5236 + 0.1 * i),
            0.005 * i);
    for (int i = 0; i < 160; ++i)
      add(-0.3 + 0.006 * (i % 4), 0.006 * (i / 4 % 4), 1.5 + 0.006 * (i / 16));
    scan.close();
    Skeleton plant;
    std::optional<NodeId> parent;
    for (int i = 0; i <= 20; ++i)
      parent = plant.add({.position = {0, 0, 0.1 * i}, .radius = 0.02, .parent = parent});
    writeStructure(toPath(path("stem.mtg")), plant);
    parent = NodeId{15};
    for (int i = 1; i <= 3; ++i)
      parent = plant.add({.position = {0.1 * i, 0, 1.5},
                          .radius = 0.005,
                          .parent = parent,
                          .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
    writeStructure(toPath(path("invented.mtg")), plant);
  }
  bool isAtPoints() { return label("review_place").endsWith("no wood"); }
  void walkToPoints() {
    open({path("scan.xyz"), path("stem.mtg")});
    key(Qt::Key_Period);
    ASSERT_TRUE(waitForStop());
    for (int stop = 0; stop < 20 && !isAtPoints(); ++stop)
      key(Qt::Key_Return);
  }
};

TEST_F(ReviewByRiskTest, TakesWhatIsCleanWholeAndStopsAtPointsWithoutWood) {
  open({path("scan.xyz"), path("stem.mtg")});
  const std::size_t inStretches = reviewStops(document().skeleton(), nullptr).size();
  key(Qt::Key_Period);
  ASSERT_TRUE(waitForStop());
  EXPECT_TRUE(label("review_place").endsWith(": clean")) << label("review_place").toStdString();
  EXPECT_FALSE(find<QLabel>("review_why").isVisible());
  EXPECT_GT(chosen().size(), 3U) << "two stretches and more";
  std::size_t stops = 0;
  for (; stops < 20 && !isAtPoints(); ++stops)
    key(Qt::Key_Return);
  ASSERT_TRUE(isAtPoints());
  EXPECT_LT(stops, inStretches);
  EXPECT_TRUE(chosen().empty());
  EXPECT_EQ(document().pointSelection().points().size(), 160U);
  waitForView();
  const auto seen = view().pointsInside(QRectF(view().rect()), Depth::through);
  for (const Eigen::Index point : document().pointSelection().points().points())
    EXPECT_TRUE(std::ranges::binary_search(seen, point));
  const int steps = document().undoStack().count();
  for (int left = 0; left < 20; ++left)
    key(Qt::Key_Return);
  EXPECT_EQ(window().statusLine().shownText(), "All is reviewed: the structure can be signed");
  EXPECT_TRUE(document().pointSelection().isEmpty() || chosen().empty());
  EXPECT_GE(document().undoStack().count(), steps);
  key(Qt::Key_Period);
  for (int stop = 0; stop < 12; ++stop, key(Qt::Key_Period))
    EXPECT_FALSE(isAtPoints()) << "they are taken for no wood";
}

TEST_F(ReviewByRiskTest, UndoBringsPointsBackThatWereTakenForNoWood) {
  walkToPoints();
  ASSERT_TRUE(isAtPoints());
  EXPECT_FALSE(action("undo").text().contains("no wood"));
  const PointSet points = document().pointSelection().points();
  const int steps = document().undoStack().index();
  const QString left = label("review_place");
  key(Qt::Key_Return);
  EXPECT_FALSE(isAtPoints());
  EXPECT_TRUE(action("undo").text().contains("Take points for no wood"));
  key(Qt::Key_Return); // marks what comes next
  ASSERT_EQ(document().undoStack().index(), steps + 1);
  EXPECT_FALSE(action("undo").text().contains("no wood"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().undoStack().index(), steps);
  EXPECT_FALSE(isAtPoints());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().undoStack().index(), steps) << "no other step is undone";
  EXPECT_TRUE(isAtPoints());
  EXPECT_EQ(document().pointSelection().points(), points);
  EXPECT_EQ(label("review_place"), left);
  EXPECT_EQ(window().statusLine().shownText(), "Undone: Take points for no wood");
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(isAtPoints()) << "they are taken for none again";
}

TEST_F(ReviewByRiskTest, DescribesTheStopAsItIsAfterAnUndo) {
  walkToPoints();
  ASSERT_TRUE(isAtPoints());
  document().selection().set({document().skeleton().roots().front()});
  key(Qt::Key_Period);
  const QString place = label("review_place");
  const QString count = place.section(' ', 0, 0);
  action("select_all").trigger();
  action("mark_all_selected").trigger();
  key(Qt::Key_Period);
  EXPECT_NE(label("review_place").section(' ', 0, 0), count);
  action("undo").trigger();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return label("review_place").section(' ', 0, 0) == count; }, patience))
      << label("review_place").toStdString();
}

TEST_F(ReviewByRiskTest, LeavesPointsInDoubtUntilOneComesBackToThem) {
  walkToPoints();
  ASSERT_TRUE(isAtPoints());
  key(Qt::Key_Return, Qt::ShiftModifier);
  for (int stop = 0; stop < 20; ++stop)
    key(Qt::Key_Return);
  EXPECT_EQ(window().statusLine().shownText(),
            "Nothing is to do; points without wood are doubtful: Ctrl+. walks there");
  key(Qt::Key_Period, Qt::ControlModifier);
  EXPECT_TRUE(isAtPoints());
  key(Qt::Key_Return);
  EXPECT_EQ(window().statusLine().shownText(), "All is reviewed: the structure can be signed");
}

TEST_F(ReviewByRiskTest, TakesNoPointsThatAreNotShownAndLeavesThoseThatAreSetAside) {
  walkToPoints();
  ASSERT_TRUE(isAtPoints());
  action("layer_points").setChecked(false);
  key(Qt::Key_Return);
  EXPECT_TRUE(isAtPoints()) << "nobody sees them";
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Nothing is marked"))
      << window().statusLine().shownText().toStdString();
  action("layer_points").setChecked(true);
  document().leaveOut("Set aside", document().pointSelection().points());
  for (int enter = 0; enter < 20; ++enter)
    key(Qt::Key_Return);
  EXPECT_FALSE(isAtPoints());
  while (!document().leftOut().isEmpty() && document().undoStack().canUndo())
    action("undo").trigger(); // they are points without wood again, that nobody has taken
  key(Qt::Key_Period, Qt::ControlModifier);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        key(Qt::Key_Period, Qt::ControlModifier);
        return isAtPoints();
      },
      patience));
}

TEST_F(ReviewByRiskTest, LooksCloserAtWhatIsRiskyAndComesToItFirstIfAsked) {
  open({path("scan.xyz"), path("invented.mtg")});
  key(Qt::Key_Period);
  ASSERT_TRUE(waitForStop());
  const NodeId twig = nodeAt({0.2, 0, 1.5}); // its first stretch
  EXPECT_EQ(std::ranges::count(chosen(), twig), 0);
  key(Qt::Key_F9, Qt::ShiftModifier);
  EXPECT_TRUE(action("riskiest_first").isChecked());
  EXPECT_EQ(std::ranges::count(chosen(), twig), 1);
  EXPECT_TRUE(label("review_place").contains(": risk "));
  EXPECT_TRUE(find<QLabel>("review_why").isVisible());
  EXPECT_TRUE(label("review_why").startsWith("The riskiest wood of this stop: "))
      << label("review_why").toStdString();
  restart();
  EXPECT_TRUE(action("riskiest_first").isChecked());
}

TEST_F(ReviewByRiskTest, FindsErrorsAnewAfterAnEdit) {
  open({path("scan.xyz"), path("stem.mtg")});
  key(Qt::Key_Period);
  ASSERT_TRUE(waitForStop());
  NodeId added{};
  document().edit("Invent", [&](SkeletonEditor& editor) {
    added = editor.add({.position = {0.15, 0, 1},
                        .radius = 0.005,
                        .parent = NodeId{10},
                        .edge = EdgeType::branching});
  });
  const auto riskOfAdded = [&] {
    document().selection().set({NodeId{10}, added}); // not the stop itself
    key(Qt::Key_Period);
    EXPECT_EQ(chosen(), std::vector{added});
    return label("review_place").section(": ", 1);
  };
  EXPECT_EQ(riskOfAdded(), "risk 100 %") << "nothing is known of it yet";
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return riskOfAdded().startsWith("risk ") && riskOfAdded() != "risk 100 %"; },
      patience));
}

} // namespace
} // namespace espalier
