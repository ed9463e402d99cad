// Points that are not of the plant are found, and set aside, in the real window.
#include "tests/app/window/project_fixture.h"
#include "ui/panels/clean_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTextStream>

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
  void findIsolated() { choose("Leave out isolated points"); }
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

TEST_F(CleaningTest, FollowsItsOptions) {
  findIsolated();
  auto& distance = *find<CleanPanel>("clean_panel").findChild<QDoubleSpinBox*>("distance");
  distance.setValue(distance.minimum());
  waitUntilFound();
  EXPECT_GT(chosen().size(), 3);
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

} // namespace
} // namespace espalier
