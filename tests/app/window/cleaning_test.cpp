// Points that are not of the plant are found, and set aside, in the real window.
#include "tests/app/window/project_fixture.h"
#include "ui/panels/clean_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QStyleOptionButton>
#include <QTest>
#include <QTextStream>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace espalier {
namespace {

/// Over the scan of a trunk with three branches and of three points far from each other and it.
class CleaningTest : public test::ProjectWindowTest {
protected:
  void SetUp() override {
    QFile file(writeScan("scan.xyz"));
    ASSERT_TRUE(file.open(QIODevice::Append));
    QTextStream(&file) << "1 0.5 0.3\n-0.9 0.5 0.2\n0.7 -0.8 1.9\n";
    file.close();
    open({path("scan.xyz")});
    action("show_cleaning").trigger();
  }

  [[nodiscard]] PointSet chosen() { return document().pointSelection().points(); }
  [[nodiscard]] QString result() { return find<QLabel>("clean_result").text(); }
  void choose(const QString& text) {
    auto& methods = find<QComboBox>("clean_method");
    methods.setCurrentIndex(methods.findText(text));
    emit methods.activated(methods.currentIndex());
    waitUntilFound();
  }
  void waitUntilFound() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !find<QPushButton>("clean_cancel").isVisible(); },
                                patience));
  }
  void findIsolated() { choose("Clean: Leave out isolated points"); }
};

TEST_F(CleaningTest, SelectsWhatIsFound) {
  EXPECT_TRUE(chosen().isEmpty()) << "nothing before one has chosen";
  EXPECT_FALSE(find<QPushButton>("clean_set_aside").isEnabled());
  findIsolated();
  EXPECT_EQ(chosen().size(), 3);
  EXPECT_TRUE(result().startsWith("Selected: 3 of ")) << result().toStdString();
  EXPECT_TRUE(find<QPushButton>("clean_set_aside").isEnabled());
  EXPECT_EQ(document().undoStack().count(), 0) << "to find is no edit";
}

TEST_F(CleaningTest, IsNotCutOffInASmallWindow) {
  window().resize(1280, 800);
  choose("Ground: Cloth");
  auto& page = find<QWidget>("clean_panel");
  const auto isCutOff = [&](const QWidget* part) {
    const int left = part->mapTo(&page, QPoint(0, 0)).x();
    return part->isVisible() && (left < 0 || left + part->width() > page.width());
  };
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return std::ranges::none_of(page.findChildren<QWidget*>(), isCutOff); }, patience));
  const auto& button = find<QPushButton>("clean_set_aside");
  QStyleOptionButton option;
  option.initFrom(&button);
  const int room =
      button.style()->subElementRect(QStyle::SE_PushButtonContents, &option, &button).width();
  EXPECT_LE(button.fontMetrics().horizontalAdvance(button.text()), room);
}

TEST_F(CleaningTest, KeepsTheKeysInThePanel) {
  findIsolated();
  auto& button = find<QPushButton>("clean_set_aside");
  button.setFocus();
  button.click();
  EXPECT_EQ(window().focusWidget(), &find<QWidget>("clean_method")) << "where the next is chosen";
}

TEST_F(CleaningTest, FollowsItsOptions) {
  findIsolated();
  auto& distance = *find<CleanPanel>("clean_panel").findChild<QDoubleSpinBox*>("distance");
  distance.setValue(distance.minimum());
  waitUntilFound();
  EXPECT_GT(chosen().size(), 3);
}

TEST_F(CleaningTest, KeepsTheOptionsOfEachMethodUntilAnotherScan) {
  const auto distance = [this] {
    return find<CleanPanel>("clean_panel").findChild<QDoubleSpinBox*>("distance");
  };
  findIsolated();
  const double usual = distance()->value();
  distance()->setValue(2 * usual);
  waitUntilFound();
  clickButton("clean_set_aside");
  choose("Ground: Cloth");
  EXPECT_EQ(distance(), nullptr);
  findIsolated();
  EXPECT_DOUBLE_EQ(distance()->value(), 2 * usual);
  open({writeScan("other.xyz")});
  findIsolated();
  EXPECT_LT(distance()->value(), 2 * usual);
}

TEST_F(CleaningTest, FindsAgainWhatTheHandHasChanged) {
  EXPECT_FALSE(find<QPushButton>("clean_again").isEnabled()) << "nothing is chosen yet";
  findIsolated();
  const PointSet found = chosen();
  document().pointSelection().clear();
  clickButton("clean_again");
  waitUntilFound();
  EXPECT_EQ(chosen(), found);
}

TEST_F(CleaningTest, HasButtonsForBrushBoxAndLasso) {
  for (const char* shape : {"points_box", "points_lasso", "points_brush"}) {
    action(shape).trigger();
    for (const char* other : {"points_box", "points_lasso", "points_brush"})
      EXPECT_EQ(action(other).isChecked(), std::string_view(other) == shape) << other;
  }
  EXPECT_TRUE(action("tool_points").isChecked());
  action("points_pole").trigger();
  EXPECT_FALSE(action("points_brush").isChecked());
}

// What is set aside is not counted, measured, framed or colored.
TEST_F(CleaningTest, CountsAndMeasuresThePointsInUse) {
  QFile file(path("scan.xyz"));
  ASSERT_TRUE(file.open(QIODevice::Append));
  QTextStream text(&file);
  for (int i = 0; i < 400; ++i) // ground that reaches far, all at once
    text << 0.25 * (i % 20) - 2.5 << ' ' << 0.25 * (i / 20) - 2.5 << " -0.6\n";
  file.close();
  open({path("scan.xyz")});
  action("show_cleaning").trigger();
  const auto all = static_cast<std::size_t>(document().scan()->cloud()->size());
  const QString size = find<QLabel>("scan_size").text();
  EXPECT_EQ(find<QLabel>("scan_points").text(), formatCount(all));
  std::vector<Eigen::Index> ground;
  const PointCloud& cloud = *document().scan()->cloud();
  for (Eigen::Index point = 0; point < cloud.size(); ++point)
    if (cloud.position(point).z() < -0.5) ground.push_back(point);
  ASSERT_EQ(ground.size(), 400);
  const Eigen::AlignedBox3d before = view().bounds();
  document().pointSelection().set(PointSet::of(ground));
  action("set_points_aside").trigger();
  waitForView();
  EXPECT_EQ(find<QLabel>("scan_points").text(),
            QString("%1 of %2").arg(formatCount(all - 400), formatCount(all)));
  EXPECT_NE(find<QLabel>("scan_size").text(), size);
  EXPECT_GT(view().bounds().min().z(), -0.5);
  action("undo").trigger();
  waitForView();
  EXPECT_EQ(find<QLabel>("scan_size").text(), size);
  EXPECT_TRUE(view().bounds().isApprox(before));
}

TEST_F(CleaningTest, ShowsNothingSetAsideOfTheNextScan) {
  findIsolated();
  clickButton("clean_set_aside");
  action("show_set_aside").trigger();
  ASSERT_TRUE(action("show_set_aside").isChecked());
  open({writeScan("other.xyz")});
  EXPECT_FALSE(action("show_set_aside").isChecked());
}

TEST_F(CleaningTest, SaysThatThereIsNothingLeft) {
  findIsolated();
  clickButton("clean_set_aside");
  findIsolated();
  EXPECT_TRUE(chosen().isEmpty());
  EXPECT_EQ(result(), "Clean: nothing found");
  EXPECT_FALSE(find<QPushButton>("clean_set_aside").isEnabled());
}

TEST_F(CleaningTest, SetsAsideByOneStepThatIsUndone) {
  findIsolated();
  const PointSet found = chosen();
  clickButton("clean_set_aside");
  EXPECT_EQ(document().leftOut(), found);
  EXPECT_TRUE(chosen().isEmpty());
  EXPECT_EQ(document().undoStack().undoText(), "Clean: Set 3 points aside");
  EXPECT_TRUE(find<QLabel>("clean_aside").text().startsWith("Set aside: 3 of "));
  action("undo").trigger();
  EXPECT_TRUE(document().leftOut().isEmpty());
  EXPECT_EQ(find<QLabel>("clean_aside").text(), "No point is set aside");
  findIsolated();
  EXPECT_EQ(chosen(), found);
}

TEST_F(CleaningTest, NamesNoMethodOnceTheHandHasChangedWhatIsFound) {
  findIsolated();
  document().pointSelection().set(PointSet::of({chosen().points().front()}));
  clickButton("clean_set_aside");
  EXPECT_EQ(document().undoStack().undoText(), "Set 1 point aside");
}

TEST_F(CleaningTest, ForgetsWhatItFoundInAnotherScan) {
  findIsolated();
  open({writeScan("other.xyz")});
  EXPECT_EQ(find<QComboBox>("clean_method").currentIndex(), -1);
  EXPECT_TRUE(chosen().isEmpty());
}

TEST_F(CleaningTest, SelectsWhatTheClipShows) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-0.2, -0.2, -1), Eigen::Vector3d(0.2, 0.2, 0.5));
  view().setClip({.slab = {}, .box = box});
  action("select_shown_points").trigger();
  ASSERT_FALSE(chosen().isEmpty());
  const PointCloud& cloud = *document().scan()->cloud();
  for (Eigen::Index point = 0; point < cloud.size(); ++point)
    EXPECT_EQ(chosen().contains(point), box.contains(cloud.position(point)));
}

/// Beside the plant stands a pole, and a wire hangs from it.
class CleaningByClicks : public CleaningTest {
protected:
  void SetUp() override {
    QFile file(writeScan("scan.xyz"));
    ASSERT_TRUE(file.open(QIODevice::Append));
    QTextStream text(&file);
    for (int i = 0; i < 3000; ++i) { // 2 m high, 5 cm wide, evenly around
      const double turn = 2.399963 * i;
      text << 2 + 0.05 * std::cos(turn) << ' ' << 0.05 * std::sin(turn) << ' ' << i / 1500.0
           << '\n';
    }
    for (int i = 0; i < 1000; ++i) { // 2 m long
      const double along = i / 500.0;
      text << 2.1 + along << " 0 " << 1.6 + 0.1 * (along - 1) * (along - 1) << '\n';
    }
    file.close();
    open({path("scan.xyz")});
    action("show_cleaning").trigger();
    action("view_front").trigger();
    waitForView();
  }

  void clickOn(const Eigen::Vector3d& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    click(view().project(place).value().toPoint(), modifiers);
    waitUntilFound();
  }
  /// How many of the chosen points lie between these x, and how many beside them.
  std::pair<int, int> chosenBetween(double least, double most) {
    std::pair<int, int> counts;
    for (const Eigen::Index point : chosen().points()) {
      const double x = document().scan()->cloud()->position(point).x();
      ++(x >= least && x <= most ? counts.first : counts.second);
    }
    return counts;
  }
};

TEST_F(CleaningByClicks, SelectAPole) {
  action("points_pole").trigger();
  EXPECT_TRUE(action("points_pole").isChecked());
  clickOn({2, -0.05, 1});
  const auto [onPole, beside] = chosenBetween(1.9, 2.1);
  EXPECT_GT(onPole, 2950);
  EXPECT_LT(beside, 30);
  clickButton("clean_set_aside");
  EXPECT_TRUE(document().undoStack().undoText().startsWith("Pole: Set "));
  action("undo").trigger();
  EXPECT_TRUE(document().leftOut().isEmpty());
}

TEST_F(CleaningByClicks, SelectAWireByItsEnds) {
  action("points_wire").trigger();
  clickOn({2.4, 0, 1.6 + 0.1 * 0.49});
  EXPECT_TRUE(chosen().isEmpty()) << "the other end is missing";
  clickOn({3.6, 0, 1.6 + 0.1 * 0.25});
  const auto [onWire, beside] = chosenBetween(2.06, 4.2);
  EXPECT_GT(onWire, 950);
  EXPECT_LT(beside, 30);
}

TEST_F(CleaningByClicks, SayThatThereIsNone) {
  action("points_pole").trigger();
  clickOn({3.1, 0, 1.6});
  EXPECT_TRUE(chosen().isEmpty());
  EXPECT_EQ(result(), "Pole: none was found there");
}

} // namespace
} // namespace espalier
