// What points lie on is found, shown and corrected by hand, in the real window.
#include "tests/app/window/project_fixture.h"
#include "tests/support/leafy_plants.h"
#include "ui/panels/status_line.h"

#include <QFile>
#include <QMouseEvent>
#include <QTest>
#include <QTextStream>

#include <algorithm>

namespace espalier {
namespace {

class OrganTest : public test::ProjectWindowTest {
protected:
  void SetUp() override {
    open({writeHerb("herb.xyz")});
    action("view_front").trigger();
    waitForView();
  }

  QString writeHerb(const QString& name) const {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    QTextStream text(&file);
    const PointCloud& cloud = test::leafyHerb().cloud;
    for (Eigen::Index i = 0; i < cloud.size(); ++i) {
      const Eigen::Vector3d place = cloud.position(i);
      text << place.x() << ' ' << place.y() << ' ' << place.z() << '\n';
    }
    return file.fileName();
  }
  [[nodiscard]] QImage picture() { return view().picture({300, 300}); }
  void choose(const PointSet& points) { document().pointSelection().set(points); }
  [[nodiscard]] QString undoText() { return document().undoStack().undoText(); }
  /// Colors by organ, and waits until they are found.
  void showOrgans() {
    const QImage before = picture();
    action("color_organ").trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return picture() != before; }, patience));
  }
  void send(QEvent::Type type, const QPoint& at, Qt::MouseButton button) {
    QMouseEvent event(type, QPointF(at), QPointF(view().mapToGlobal(at)), button, Qt::LeftButton,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(&view(), &event);
  }
  void stroke(const QPoint& at) {
    hover(at);
    send(QEvent::MouseButtonPress, at, Qt::LeftButton);
    send(QEvent::MouseMove, at, Qt::NoButton);
    send(QEvent::MouseButtonRelease, at, Qt::LeftButton);
  }
  /// How many pixels have about this color.
  static int pixelsOf(const QImage& image, const QColor& color) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor pixel = image.pixelColor(x, y);
        count += std::abs(pixel.red() - color.red()) < 12 &&
                 std::abs(pixel.green() - color.green()) < 12 &&
                 std::abs(pixel.blue() - color.blue()) < 12;
      }
    return count;
  }
};

const QColor blade(0x00, 0x9e, 0x73);
const QColor needle(0x00, 0x72, 0xb2);

TEST_F(OrganTest, PointsAreColoredByTheirOrganOnceItIsFound) {
  ASSERT_LT(pixelsOf(picture(), blade), 20);
  showOrgans();
  EXPECT_GT(pixelsOf(picture(), blade), 100);
  EXPECT_EQ(document().undoStack().count(), 0) << "to look is no edit";
  action("color_height").trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return pixelsOf(picture(), blade) < 20; }, patience));
}

TEST_F(OrganTest, ASelectionIsSetByOneStepThatIsUndone) {
  showOrgans();
  const int before = pixelsOf(picture(), needle);
  const PointSet some = PointSet::firstOf(3000);
  choose(some);
  key(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().organs().of(Organ::needle), some);
  EXPECT_TRUE(document().pointSelection().isEmpty());
  EXPECT_EQ(undoText(), "Set " + formatCount(3000) + " points to needle");
  EXPECT_TRUE(window().statusLine().counts().contains(formatCount(3000) + " organs by hand"));
  EXPECT_TRUE(window().statusLine().shownText().contains("step Leaves is on"));
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return pixelsOf(picture(), needle) > before + 100; }, patience));
  action("undo").trigger();
  EXPECT_TRUE(document().organs().isEmpty());
  EXPECT_TRUE(QTest::qWaitFor([&] { return pixelsOf(picture(), needle) == before; }, patience));
  action("redo").trigger();
  EXPECT_EQ(document().organs().of(Organ::needle), some);
}

TEST_F(OrganTest, EachOrganHasItsActionAndIsLetGo) {
  const std::pair<const char*, Organ> organs[] = {{"organ_wood", Organ::wood},
                                                  {"organ_petiole", Organ::petiole},
                                                  {"organ_blade", Organ::blade},
                                                  {"organ_needle", Organ::needle}};
  EXPECT_FALSE(action("organ_found").isEnabled());
  Eigen::Index first = 0;
  for (const auto& [id, organ] : organs) {
    choose(PointSet::of({first, first + 1}));
    action(id).trigger();
    EXPECT_EQ(document().organs().of(organ), PointSet::of({first, first + 1})) << id;
    first += 10;
  }
  choose(PointSet::of({0, 30}));
  key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().organs().of(Organ::wood), PointSet::of({1}));
  EXPECT_EQ(document().organs().of(Organ::needle), PointSet::of({31}));
  EXPECT_EQ(undoText(), "Let the organ of 2 points be found");
  action("organ_found").trigger();
  EXPECT_TRUE(document().organs().isEmpty()) << "all, as none is selected";
  EXPECT_EQ(document().undoStack().count(), 6);
}

TEST_F(OrganTest, TheBrushPaintsAnOrganUntilItIsChosenAgain) {
  action("organ_blade").trigger();
  EXPECT_TRUE(action("organ_blade").isChecked());
  EXPECT_TRUE(action("tool_points").isChecked());
  const QPoint at = view().project(document().scan()->cloud()->position(6000)).value().toPoint();
  hover(at);
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Points become blade"));
  stroke(at);
  const PointSet painted = document().organs().of(Organ::blade);
  EXPECT_FALSE(painted.isEmpty());
  EXPECT_TRUE(document().pointSelection().isEmpty());
  action("organ_wood").trigger();
  EXPECT_FALSE(action("organ_blade").isChecked());
  stroke(at);
  EXPECT_EQ(document().organs().of(Organ::wood), painted);
  EXPECT_TRUE(document().organs().of(Organ::blade).isEmpty());
  EXPECT_EQ(document().undoStack().count(), 2) << "a step for each stroke";
  action("organ_wood").trigger();
  EXPECT_FALSE(action("organ_wood").isChecked());
  stroke(at);
  EXPECT_EQ(document().undoStack().count(), 2) << "points are only selected again";
  EXPECT_EQ(document().pointSelection().points(), painted);
}

TEST_F(OrganTest, AnotherToolPaintsNoOrgan) {
  action("organ_needle").trigger();
  key(Qt::Key_S);
  EXPECT_FALSE(action("organ_needle").isChecked());
}

TEST_F(OrganTest, AProjectKeepsWhatWasSetByHand) {
  const QString file = saveProject("herb.espalier");
  choose(PointSet::firstOf(700));
  action("organ_blade").trigger();
  EXPECT_EQ(onDisk(file).organs, document().organs()) << "it is on the disk at once";
  choose(PointSet::of({5, 6}));
  action("organ_wood").trigger();
  action("undo").trigger();
  open({file});
  EXPECT_EQ(document().organs().of(Organ::blade), PointSet::firstOf(700));
  action("redo").trigger();
  EXPECT_EQ(document().organs().of(Organ::wood), PointSet::of({5, 6}));
}

TEST_F(OrganTest, AReconstructionTakesWhatWasSetByHand) {
  PipelineOptions options = this->options();
  options.set("leaves.method=shapes");
  window().findChild<PipelinePanel*>()->setOptions(options);
  const auto highest = [this] {
    double z = -1;
    for (const NodeId id : document().skeleton().ids())
      z = std::max(z, document().skeleton()[id].position.z());
    return z;
  };
  action("reconstruct").trigger();
  waitForJob();
  const double before = highest();
  std::vector<Eigen::Index> upper;
  for (Eigen::Index i = 0; i < document().scan()->cloud()->size(); ++i)
    if (document().scan()->cloud()->position(i).z() > before / 2) upper.push_back(i);
  choose(PointSet::of(upper));
  action("organ_blade").trigger();
  EXPECT_TRUE(window().statusLine().shownText().contains("from the next reconstruction on"));
  action("reconstruct").trigger();
  waitForJob();
  const QString byHand = formatCount(upper.size()) + " were set by hand";
  EXPECT_TRUE(message().contains(byHand)) << message().toStdString();
  EXPECT_LT(highest(), 0.55 * before);
  EXPECT_GT(highest(), 0.2 * before);
}

TEST_F(OrganTest, ThatAreNotWaitedForAreFoundWhenTheyAreAskedForAgain) {
  action("color_organ").trigger();
  clickButton("cancel_job");
  EXPECT_TRUE(window().statusLine().shownText().contains("Canceled"));
  QTest::qWait(100);
  EXPECT_LT(pixelsOf(picture(), blade), 20);
  action("color_organ").trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return pixelsOf(picture(), blade) > 100; }, patience));
}

TEST_F(OrganTest, AreFoundAgainWhereOtherPointsAreSetAside) {
  showOrgans();
  std::vector<Eigen::Index> upper;
  for (Eigen::Index i = 0; i < document().scan()->cloud()->size(); ++i)
    if (document().scan()->cloud()->position(i).z() > 0.3) upper.push_back(i);
  const int before = pixelsOf(picture(), blade);
  choose(PointSet::of(upper));
  action("set_points_aside").trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return pixelsOf(picture(), blade) < before / 2; }, patience));
}

} // namespace
} // namespace espalier
