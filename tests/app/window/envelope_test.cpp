// The envelope about the crown, in the real window.
#include "core/base/random.h"
#include "core/pipeline/envelopes.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/status_line.h"

#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <nlohmann/json.hpp>

#include <fstream>

namespace espalier {
namespace {

/// A scan of a trunk with three branches, in m.
struct EnvelopeTest : test::ProjectWindowTest {
  void openScan() {
    open({writeScan("plant.xyz")});
    document().setUnit(LengthUnit::meter);
    action("show_crown_envelope").trigger();
  }
  void choose(const QString& kind) {
    auto& kinds = find<QComboBox>("envelope_kind");
    kinds.setCurrentIndex(kinds.findData(kind));
    choice_ = kind;
  }
  [[nodiscard]] QString handleText() { return find<QLabel>("envelope_handles").text(); }
  /// A number of the panel; empty: it is not there.
  [[nodiscard]] QString number(const QString& name) {
    for (const QLabel* value : window().findChildren<QLabel*>("envelope_value"))
      if (value->accessibleName() == name && value->isVisible()) return value->text();
    return {};
  }
  [[nodiscard]] bool waitFor(const QString& volume) {
    return QTest::qWaitFor([&] { return number("Volume") == volume; }, patience);
  }
  /// As the window is to fit it.
  [[nodiscard]] Envelope fitted(const std::string& kind) {
    const EnvelopeKind& how = envelopeKindNamed(kind);
    return envelopeAbout(placesOf(*document().scan()->cloud(), document().leftOut()), UpAxis::z,
                         how, envelopeValues(how, {}, document().scale(), 1));
  }
  [[nodiscard]] static QString volumeOf(const Envelope& envelope) {
    return formatVolume(envelope.volume, LengthUnit::meter);
  }
  [[nodiscard]] QPoint handle(const Envelope& envelope, const std::string& name) {
    const std::string kind = choice_.toStdString();
    for (const EnvelopeHandle& each : envelopeHandles(envelope, UpAxis::z, envelopeKindNamed(kind)))
      if (each.name == name) return view().project(each.place).value_or(QPointF()).toPoint();
    return {};
  }
  /// How far a handle moves on the screen that is pulled out by a tenth of the height.
  [[nodiscard]] QPoint step(const Envelope& envelope, const std::string& name) {
    const std::string kind = choice_.toStdString();
    for (const EnvelopeHandle& each : envelopeHandles(envelope, UpAxis::z, envelopeKindNamed(kind)))
      if (each.name == name)
        return (view().project(each.place + 0.1 * envelope.height * each.up).value_or(QPointF()) -
                view().project(each.place).value_or(QPointF()))
            .toPoint();
    return {};
  }
  /// Whether the mouse might take another one.
  [[nodiscard]] bool nearOthers(const Envelope& envelope, const std::string& name) {
    const QPoint place = handle(envelope, name);
    return std::ranges::any_of(
        envelopeKindNamed(choice_.toStdString()).handles, [&](const std::string& other) {
          return other != name && (handle(envelope, other) - place).manhattanLength() < 25;
        });
  }
  void showFitted(const QString& kind) {
    choose(kind);
    ASSERT_TRUE(waitFor(volumeOf(fitted(kind.toStdString())))) << number("Volume").toStdString();
    waitForView();
  }
  void showAsymmetric() {
    openScan();
    showFitted("asymmetric");
  }
  /// Presses a handle and pulls it, without letting go.
  void pull(const QPoint& from, const QPoint& by) {
    hover(from);
    QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
    for (int step = 1; step <= 5; ++step)
      QTest::mouseMove(&view(), from + by * step / 5);
  }
  static int difference(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x)
        if (a.pixel(x, y) != b.pixel(x, y)) ++count;
    return count;
  }

private:
  QString choice_; // the kind that is chosen
};

TEST_F(EnvelopeTest, OfEachKindIsDrawnAndMeasured) {
  openScan();
  const QImage before = view().picture({400, 400});
  for (const EnvelopeKind& kind : envelopeKinds()) {
    SCOPED_TRACE(kind.form.name);
    choose(QString::fromStdString(kind.form.name));
    EXPECT_TRUE(waitFor(volumeOf(fitted(kind.form.name)))) << number("Volume").toStdString();
    EXPECT_TRUE(number("Area").endsWith("m²")) << number("Area").toStdString();
    EXPECT_TRUE(number("Height").endsWith("m"));
    int heights = 0;
    for (const QLabel* value : window().findChildren<QLabel*>("envelope_value"))
      heights += value->accessibleName() == "Height";
    EXPECT_EQ(heights, 1);
  }
  EXPECT_GT(difference(before, view().picture({400, 400})), 2000) << "it is to be seen";
  find<QComboBox>("envelope_kind").setCurrentIndex(0);
  EXPECT_EQ(view().picture({400, 400}), before);
  EXPECT_EQ(number("Volume"), "");
}

TEST_F(EnvelopeTest, FollowsItsOptionsAndThePlant) {
  openScan();
  choose("ball");
  ASSERT_TRUE(waitFor(volumeOf(fitted("ball"))));
  document().setUnit(LengthUnit::millimeter);
  EXPECT_TRUE(waitFor(formatVolume(fitted("ball").volume, LengthUnit::millimeter)));
  document().setUnit(LengthUnit::meter);
  const QString whole = volumeOf(fitted("ball"));
  ASSERT_TRUE(waitFor(whole));
  std::vector<Eigen::Index> upper;
  for (Eigen::Index i = 0; i < document().scan()->cloud()->size(); ++i)
    if (document().scan()->cloud()->position(i).z() > 1) upper.push_back(i);
  document().leaveOut("Set aside", PointSet::of(upper));
  EXPECT_TRUE(waitFor(volumeOf(fitted("ball"))));
  EXPECT_NE(volumeOf(fitted("ball")), whole);
}

TEST_F(EnvelopeTest, IsAboutTheSkeletonWhereThereAreNoPoints) {
  open({writeFork("fork.mtg")});
  document().setUnit(LengthUnit::meter);
  action("show_crown_envelope").trigger();
  choose("ball");
  const EnvelopeKind& ball = envelopeKindNamed("ball");
  const Envelope expected = envelopeAbout(placesOf(document().skeleton()), UpAxis::z, ball,
                                          envelopeValues(ball, {}, {.spacing = 1, .height = 2}, 1));
  EXPECT_TRUE(waitFor(volumeOf(expected))) << number("Volume").toStdString();
  EXPECT_FALSE(find<QComboBox>("envelope_about").isEnabled());
}

TEST_F(EnvelopeTest, SaysWhyItCannotBe) {
  open({writeFork("fork.mtg")});
  const std::vector<NodeId> shoots = document().skeleton().children(test::forkTop);
  document().edit("Remove", [&](SkeletonEditor& editor) {
    for (const NodeId shoot : shoots)
      editor.erase(shoot);
  });
  action("show_crown_envelope").trigger();
  choose("convex");
  auto& words = find<QLabel>("envelope_words");
  EXPECT_TRUE(QTest::qWaitFor([&] { return words.text().contains("envelope"); }, patience))
      << words.text().toStdString();
  EXPECT_TRUE(words.isVisible());
  EXPECT_FALSE(action("write_envelope").isEnabled());
}

TEST_F(EnvelopeTest, HasATopToDrag) {
  showAsymmetric();
  const Envelope before = fitted("asymmetric");
  const QPoint top = handle(before, "top");
  drag(top, top - QPoint(0, 60));
  EXPECT_NE(number("Volume"), volumeOf(before));
  EXPECT_TRUE(window().statusLine().shownText().startsWith("The envelope holds"))
      << window().statusLine().shownText().toStdString();
  EXPECT_TRUE(find<QPushButton>("envelope_fit").isVisible());
  clickButton("envelope_fit");
  EXPECT_EQ(number("Volume"), volumeOf(before));
  EXPECT_FALSE(find<QPushButton>("envelope_fit").isVisible());
}

TEST_F(EnvelopeTest, SaysWhatADragOfAHandleMoves) {
  openScan();
  showFitted("cone");
  const Envelope cone = fitted("cone");
  // What was noted stays for a glance, or until it has been there long enough.
  ASSERT_TRUE(QTest::qWaitFor(
      [this] { return !window().statusLine().shownText().startsWith("Crown envelope"); },
      patience));
  hover(handle(cone, "top"));
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Drag: move "))
      << window().statusLine().shownText().toStdString();
  hover({3, 3});
  EXPECT_FALSE(window().statusLine().shownText().startsWith("Drag: move "));
}

// The shape of before is not what is asked for.
TEST_F(EnvelopeTest, SaysHowFarTheDrawingOfAnotherKindIs) {
  std::ofstream out(path("ball.xyz").toStdString());
  Random random(3);
  for (int i = 0; i < 30'000; ++i)
    out << (std::cbrt(random.uniform()) * random.direction()).transpose() << '\n';
  out.close();
  open({path("ball.xyz")});
  document().setUnit(LengthUnit::meter);
  action("show_crown_envelope").trigger();
  choose("ball");
  ASSERT_TRUE(QTest::qWaitFor([this] { return !number("Volume").isEmpty(); }, patience));
  choose("alpha");
  const auto& words = find<QLabel>("envelope_words");
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return words.isVisible() && words.text().startsWith("Drawing it…"); }, patience));
  EXPECT_EQ(number("Volume"), "");
  ASSERT_TRUE(QTest::qWaitFor([this] { return !number("Volume").isEmpty(); }, patience));
  EXPECT_FALSE(words.isVisible());
}

TEST_F(EnvelopeTest, HasSidesToDrag) {
  showAsymmetric();
  const Envelope before = fitted("asymmetric");
  const QString radius = number("Radius ahead");
  const QPoint side = handle(before, "ahead");
  const QPoint middle = (handle(before, "top") + handle(before, "bottom")) / 2;
  drag(side, side + QPoint(side.x() > middle.x() ? 40 : -40, 0));
  EXPECT_NE(number("Volume"), volumeOf(before));
  EXPECT_NE(number("Radius ahead"), radius);
}

// All but the center, which moves the solid as it is.
TEST_F(EnvelopeTest, OfEachSolidIsSetByItsHandles) {
  openScan();
  int dragged = 0;
  for (const EnvelopeKind& kind : envelopeKinds()) {
    if (std::ranges::find(kind.handles, "center") == kind.handles.end()) continue;
    showFitted(QString::fromStdString(kind.form.name));
    const Envelope before = fitted(kind.form.name);
    EXPECT_EQ(handleText(), "Drag its handles to set it by hand.");
    for (const std::string& name : kind.handles) {
      SCOPED_TRACE(kind.form.name + ": " + name);
      const QPoint from = handle(before, name);
      const QPoint middle = handle(before, "center");
      const QPoint outward = from - middle;
      if (outward.manhattanLength() < 80) continue; // its center, or an axis along the sight
      ++dragged;
      drag(from, from + outward / 4);
      EXPECT_NE(number("Volume"), volumeOf(before));
      EXPECT_EQ(handleText(), "By hand: handles were dragged.");
      clickButton("envelope_fit");
      EXPECT_EQ(number("Volume"), volumeOf(before));
      EXPECT_FALSE(find<QPushButton>("envelope_fit").isVisible());
    }
  }
  EXPECT_GE(dragged, 12);
}

// It was read with the handles of the kind that was to come.
TEST_F(EnvelopeTest, OfAnotherKindIsSeenWithoutHandlesUntilItIsFitted) {
  openScan();
  choose("ball");
  ASSERT_TRUE(waitFor(volumeOf(fitted("ball"))));
  choose("asymmetric");                    // is fitted a moment later
  action("show_crown_envelope").trigger(); // hides the panel and shows it again
  action("show_crown_envelope").trigger();
  emit view().envelopeDragged(0, {0, 0, 1}); // a drag of the kind before goes on
  emit view().envelopeReleased();
  ASSERT_TRUE(waitFor(volumeOf(fitted("asymmetric"))));
  EXPECT_EQ(document().undoStack().count(), 2) << "the drag was of what is there no more";
}

TEST_F(EnvelopeTest, MovesWithItsCenter) {
  openScan();
  showFitted("ball");
  const Envelope before = fitted("ball");
  const QPoint center = handle(before, "center");
  const QPoint rim = handle(before, "radius");
  drag(center, center + QPoint(40, 30));
  EXPECT_EQ(number("Volume"), volumeOf(before)) << "as large, elsewhere";
  drag(rim + QPoint(40, 30), rim + QPoint(80, 30));
  EXPECT_NE(number("Volume"), volumeOf(before));
}

TEST_F(EnvelopeTest, ThatFollowsThePointsSaysThatItHasNoHandles) {
  openScan();
  for (const char* kind : {"convex", "alpha"}) {
    showFitted(kind);
    EXPECT_EQ(handleText(), "It follows from the plant alone: it has no handles to drag.");
    EXPECT_FALSE(find<QPushButton>("envelope_fit").isVisible());
  }
}

TEST_F(EnvelopeTest, IsGivenBackByEscapeInMidDrag) {
  showAsymmetric();
  const Envelope before = fitted("asymmetric");
  const Camera camera = view().camera();
  pull(handle(before, "top"), {0, -60});
  EXPECT_NE(number("Volume"), volumeOf(before));
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_EQ(number("Volume"), volumeOf(before));
  EXPECT_FALSE(find<QPushButton>("envelope_fit").isVisible());
  EXPECT_EQ(view().camera(), camera) << "a drag of a handle turns nothing";
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, handle(before, "top"));
  EXPECT_EQ(number("Volume"), volumeOf(before));
}

TEST_F(EnvelopeTest, IsKeptInTheProjectWithWhatWasDragged) {
  showAsymmetric();
  const QPoint top = handle(fitted("asymmetric"), "top");
  drag(top, top - QPoint(0, 60));
  const QString dragged = number("Volume");
  const QString file = saveProject("plant.espalier");
  action("new_plant").trigger();
  waitForJob();
  EXPECT_EQ(find<QComboBox>("envelope_kind").currentIndex(), 0) << "the next plant has none";
  open({file});
  EXPECT_TRUE(waitFor(dragged)) << number("Volume").toStdString();
  EXPECT_EQ(find<QComboBox>("envelope_kind").currentData(), "asymmetric");
}

TEST_F(EnvelopeTest, OfAProjectKeepsWhereItsCenterWasDraggedTo) {
  openScan();
  showFitted("cylinder");
  const QPoint center = handle(fitted("cylinder"), "center");
  drag(center, center - QPoint(60, 0));
  EXPECT_EQ(handleText(), "By hand: handles were dragged.");
  const QString file = saveProject("plant.espalier");
  const QImage dragged = view().picture({300, 300});
  action("new_plant").trigger();
  waitForJob();
  open({file});
  ASSERT_TRUE(waitFor(volumeOf(fitted("cylinder"))));
  EXPECT_EQ(handleText(), "By hand: handles were dragged.");
  EXPECT_LT(difference(view().picture({300, 300}), dragged), 900);
}

TEST_F(EnvelopeTest, ADragIsAStepOfTheHistory) {
  showAsymmetric();
  const QString before = number("Volume");
  const int steps = document().undoStack().count();
  const QPoint top = handle(fitted("asymmetric"), "top");
  drag(top, top - QPoint(0, 60));
  const QString dragged = number("Volume");
  ASSERT_NE(dragged, before);
  ASSERT_EQ(document().undoStack().count(), steps + 1) << "one step, however far";
  EXPECT_EQ(document().step(steps).text, "Crown envelope: drag top");
  action("undo").trigger();
  EXPECT_EQ(number("Volume"), before);
  EXPECT_EQ(handleText(), "Drag its handles to set it by hand.");
  action("redo").trigger();
  EXPECT_EQ(number("Volume"), dragged);
  clickButton("envelope_fit");
  EXPECT_EQ(number("Volume"), before);
  action("undo").trigger();
  EXPECT_EQ(number("Volume"), dragged) << "what was dragged is not lost";
}

TEST_F(EnvelopeTest, AnotherKindIsAStepThatBringsBackWhatWasDragged) {
  showAsymmetric();
  const QPoint top = handle(fitted("asymmetric"), "top");
  drag(top, top - QPoint(0, 60));
  const QString dragged = number("Volume");
  showFitted("ball");
  EXPECT_EQ(document().step(document().undoStack().index() - 1).text, "Crown envelope: Ball");
  action("undo").trigger();
  EXPECT_EQ(find<QComboBox>("envelope_kind").currentData(), "asymmetric");
  EXPECT_TRUE(waitFor(dragged)) << number("Volume").toStdString();
  action("redo").trigger();
  EXPECT_EQ(find<QComboBox>("envelope_kind").currentData(), "ball");
  EXPECT_TRUE(waitFor(volumeOf(fitted("ball"))));
  document().goTo(0);
  EXPECT_EQ(find<QComboBox>("envelope_kind").currentIndex(), 0);
  EXPECT_EQ(number("Volume"), "");
}

TEST_F(EnvelopeTest, ADragThatIsGivenBackIsNoStep) {
  showAsymmetric();
  const int steps = document().undoStack().count();
  pull(handle(fitted("asymmetric"), "top"), {0, -60});
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_EQ(document().undoStack().count(), steps);
}

// As the disk is at once, so it is after a kill.
TEST_F(EnvelopeTest, ADragIsInTheProjectAtOnceWithItsUndo) {
  showAsymmetric();
  const QString file = saveProject("plant.espalier");
  const QString before = number("Volume");
  const QPoint top = handle(fitted("asymmetric"), "top");
  drag(top, top - QPoint(0, 60));
  const QString dragged = number("Volume");
  for (const char* ending : {"", "-wal"})
    QFile::copy(file + ending, path("killed.espalier") + ending);
  open({path("killed.espalier")});
  EXPECT_TRUE(waitFor(dragged)) << number("Volume").toStdString();
  action("undo").trigger();
  EXPECT_TRUE(waitFor(before)) << number("Volume").toStdString();
  action("redo").trigger();
  EXPECT_TRUE(waitFor(dragged)) << number("Volume").toStdString();
}

TEST_F(EnvelopeTest, AStepThatCannotBeReadShowsNoneAndSaysSo) {
  openScan();
  document().setEnvelope("Crown envelope: egg", R"({"kind":"egg"})");
  EXPECT_EQ(find<QComboBox>("envelope_kind").currentIndex(), 0);
  EXPECT_TRUE(message().contains("cannot be read")) << message().toStdString();
  showFitted("ball");
}

TEST_F(EnvelopeTest, HullsHaveTheirProfilesToDrag) {
  openScan();
  for (const char* kind : {"extruded", "skinned"}) {
    showFitted(kind);
    const Envelope before = fitted(kind);
    int dragged = 0;
    for (const std::string& name : envelopeKindNamed(kind).handles) {
      SCOPED_TRACE(std::string(kind) + ": " + name);
      const QPoint from = handle(before, name);
      const QPoint outward = step(before, name);
      if (outward.manhattanLength() < 30) continue; // along the sight
      if (nearOthers(before, name)) continue;
      ++dragged;
      drag(from, from + outward);
      EXPECT_NE(number("Volume"), volumeOf(before));
      EXPECT_EQ(handleText(), "By hand: handles were dragged.");
      action("undo").trigger();
      EXPECT_EQ(number("Volume"), volumeOf(before));
    }
    EXPECT_GE(dragged, 5) << kind;
  }
}

TEST_F(EnvelopeTest, IsWrittenAsAMesh) {
  openScan();
  choose("convex");
  ASSERT_TRUE(waitFor(volumeOf(fitted("convex"))));
  for (const QString name : {"crown.ply", "crown.obj"}) {
    answer(chooseFile(path(name)), [this] { action("write_envelope").trigger(); });
    EXPECT_TRUE(window().statusLine().shownText().startsWith("Wrote"));
    QFile written(path(name));
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    const QByteArray begin = name.endsWith("ply") ? QByteArray("ply") : QByteArray("v ");
    EXPECT_TRUE(written.readAll().contains(begin)) << name.toStdString();
  }
}

TEST_F(EnvelopeTest, StandsInTheReportOfThePlant) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  document().setUnit(LengthUnit::meter);
  action("show_crown_envelope").trigger();
  choose("cylinder");
  const Envelope expected = fitted("cylinder");
  ASSERT_TRUE(waitFor(volumeOf(expected)));
  for (const QString name : {"report.json", "report.html"}) {
    answer(chooseFile(path(name)), [this] { action("export_plant_report").trigger(); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path(name)); }, patience));
  }
  QFile json(path("report.json"));
  ASSERT_TRUE(json.open(QIODevice::ReadOnly));
  const auto numbers = nlohmann::json::parse(json.readAll().toStdString())["envelope"];
  EXPECT_EQ(numbers["kind"], "cylinder");
  EXPECT_EQ(numbers["of"], "points");
  EXPECT_NEAR(numbers["volume"].get<double>(), expected.volume, 1e-9);
  QFile html(path("report.html"));
  ASSERT_TRUE(html.open(QIODevice::ReadOnly));
  EXPECT_TRUE(html.readAll().contains("Crown envelope"));
}

} // namespace
} // namespace espalier
