// The plant by itself, without a reference, in the real window.
#include "core/evaluate/plant_measures.h"
#include "core/skeleton/bounds.h"
#include "tests/app/window/evaluation_fixture.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/status_line.h"

#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QGridLayout>
#include <QToolButton>
#include <nlohmann/json.hpp>

namespace espalier {
namespace {

struct TraitsWindowTest : test::EvaluationWindowTest {
  void show() {
    open({write("plant.mtg", plant())});
    document().setUnit(LengthUnit::meter);
    key(Qt::Key_F5);
  }
  /// The value of a trait in the panel; empty: it is not there.
  [[nodiscard]] QString trait(const QString& name) {
    for (const QLabel* value : window().findChildren<QLabel*>("trait_value"))
      if (value->accessibleName() == name && value->isVisible()) return value->text();
    return {};
  }
  [[nodiscard]] bool waitFor(const QString& name, const QString& value) {
    return QTest::qWaitFor([&] { return trait(name) == value; }, patience);
  }
  [[nodiscard]] bool waitForNote(const QString& note) {
    return QTest::qWaitFor([&] { return window().statusLine().shownText().startsWith(note); },
                           patience);
  }
  [[nodiscard]] QByteArray bytesOf(const QString& file) {
    QFile in(file);
    EXPECT_TRUE(in.open(QIODevice::ReadOnly)) << qPrintable(file);
    return in.readAll();
  }
};

constexpr QChar narrowBlank(0x202f);

TEST_F(TraitsWindowTest, AreShownWithoutAReference) {
  show();
  ASSERT_TRUE(waitFor("Tips", "3"));
  EXPECT_EQ(trait("Height"), QString("2.00%1m").arg(narrowBlank));
  EXPECT_EQ(trait("Branching angle, order 1"), "45.0°");
  EXPECT_EQ(trait("Strahler number"), "2");
  EXPECT_TRUE(find<QToolButton>("traits_report").isVisible());
  load(write("expert.mtg", plant()));
  EXPECT_FALSE(find<QLabel>("traits_title").isVisible()) << "scores stand there";
  action("remove_reference").trigger();
  EXPECT_TRUE(find<QLabel>("traits_title").isVisible());
  EXPECT_TRUE(waitFor("Tips", "3"));
}

TEST_F(TraitsWindowTest, FollowEachEdit) {
  show();
  ASSERT_TRUE(waitFor("Tips", "3"));
  document().edit("Remove", [](SkeletonEditor& editor) {
    for (int i = 9; i >= 0; --i)
      editor.erase(NodeId{static_cast<std::uint32_t>(31 + i)}); // the last shoot
  });
  EXPECT_TRUE(waitFor("Tips", "2"));
  document().undoStack().undo();
  EXPECT_TRUE(waitFor("Tips", "3"));
  document().setUnit(LengthUnit::millimeter);
  EXPECT_TRUE(waitFor("Height", QString("2.00%1mm").arg(narrowBlank)));
}

TEST_F(TraitsWindowTest, HaveCompartmentsWithBiomassOnceADensityIsTyped) {
  show();
  ASSERT_TRUE(waitFor("Tips", "3"));
  EXPECT_NE(trait("Volume, order 0"), "");
  EXPECT_EQ(trait("Biomass, order 0"), "") << "no density is assumed";
  auto& density = find<QDoubleSpinBox>("wood_density");
  EXPECT_TRUE(density.isVisible());
  density.setValue(500);
  const double volume = plantMeasures(plant()).wood.byOrder.front().volume;
  const QString biomass = formatLength(500 * volume, LengthUnit::unknown, 3) + " kg";
  EXPECT_TRUE(waitFor("Biomass, order 0", biomass)) << trait("Biomass, order 0").toStdString();
  document().setUnit(LengthUnit::unknown);
  EXPECT_TRUE(waitFor("Biomass, order 0", "")) << "nobody knows how much a volume is";
}

TEST_F(TraitsWindowTest, FollowTheAxisThatPointsUp) {
  show();
  ASSERT_TRUE(waitFor("Height", QString("2.00%1m").arg(narrowBlank)));
  const QString lying = QString::number(bounds(plant()).sizes().x(), 'f', 2) + narrowBlank + 'm';
  action("up_x").trigger();
  EXPECT_TRUE(waitFor("Height", lying)) << trait("Height").toStdString();
}

TEST_F(TraitsWindowTest, SayWhatToDoWithoutAPlant) {
  open({writeScan("scan.xyz")});
  key(Qt::Key_F5);
  EXPECT_TRUE(find<QLabel>("evaluation_hint").isVisible());
  EXPECT_FALSE(action("measure_light").isEnabled());
  EXPECT_FALSE(action("export_plant_report").isEnabled());
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !trait("Tips").isEmpty(); }, patience));
  EXPECT_FALSE(find<QLabel>("evaluation_hint").isVisible());
  EXPECT_TRUE(action("measure_light").isEnabled());
}

TEST_F(TraitsWindowTest, LightIsMeasuredOnDemand) {
  show();
  ASSERT_TRUE(waitFor("Tips", "3"));
  EXPECT_EQ(trait("STAR"), "");
  find<QToolButton>("traits_light").click();
  EXPECT_TRUE(window().jobs().isBusy()) << "with progress and cancel in the status bar";
  waitForJob();
  const QString star = trait("STAR");
  EXPECT_GT(star.toDouble(), 0.1);
  EXPECT_LT(star.toDouble(), 1 / M_PI);
  EXPECT_TRUE(waitForNote("The plant shows " + star));
  document().edit("Radius", [](SkeletonEditor& editor) { editor.setRadius(NodeId{0}, 0.02); });
  const auto isPale = [&] {
    for (const QLabel* value : window().findChildren<QLabel*>("trait_value"))
      if (value->accessibleName() == "STAR" && value->isVisible())
        return value->property("role") == "quiet";
    return false;
  };
  const auto isNewOf = [&](const QString& name) {
    for (const QLabel* value : window().findChildren<QLabel*>("trait_value"))
      if (value->accessibleName() == name && value->isVisible())
        return value->property("role") == "value";
    return false;
  };
  EXPECT_TRUE(QTest::qWaitFor([&] { return isNewOf("Tips"); }, patience));
  EXPECT_TRUE(isPale()) << "it is of the plant before";
}

TEST_F(TraitsWindowTest, LightThatIsCanceledChangesNothing) {
  show();
  ASSERT_TRUE(waitFor("Tips", "3"));
  action("measure_light").trigger();
  window().jobs().cancel();
  waitForJob();
  EXPECT_EQ(trait("STAR"), "");
  EXPECT_TRUE(action("measure_light").isEnabled());
}

TEST_F(TraitsWindowTest, LightOfAPlantWithoutRadiiIsRefusedInWords) {
  Skeleton thin = plant();
  for (const NodeId id : thin.ids())
    thin.setRadius(id, 0);
  open({write("thin.mtg", thin)});
  action("measure_light").trigger();
  waitForJob();
  EXPECT_TRUE(message().contains("estimate radii first")) << qPrintable(message());
}

TEST_F(TraitsWindowTest, AReportOfThePlantIsOfferedItsNameAndWritten) {
  show();
  ASSERT_TRUE(waitFor("Tips", "3"));
  answer(
      [this](QDialog& dialog) {
        auto& files = dynamic_cast<QFileDialog&>(dialog);
        EXPECT_EQ(files.selectedFiles(), QStringList(path("plant.traits.html")));
        files.reject();
      },
      [this] { find<QToolButton>("traits_report").click(); });
  answer(chooseFile(path("plant.html")), [this] { action("export_plant_report").trigger(); });
  ASSERT_TRUE(waitForNote("Wrote plant.html")) << qPrintable(window().statusLine().shownText());
  EXPECT_EQ(message(), "Wrote plant.html");
  const QString html = QString::fromUtf8(bytesOf(path("plant.html")));
  EXPECT_TRUE(html.contains("<h1>plant.mtg</h1>"));
  EXPECT_TRUE(html.contains("Strahler number"));
  EXPECT_TRUE(html.contains("(STAR)"));
  EXPECT_TRUE(html.contains("Work by hand"));
  EXPECT_TRUE(action("export_plant_report").isEnabled()) << "again";
}

TEST_F(TraitsWindowTest, NumbersOfThePlantAreWrittenWithoutPictures) {
  show();
  answer(chooseFile(path("plant.json")), [this] { action("export_plant_report").trigger(); });
  ASSERT_TRUE(waitForNote("Wrote plant.json")) << qPrintable(window().statusLine().shownText());
  const auto json = nlohmann::json::parse(bytesOf(path("plant.json")).toStdString());
  EXPECT_EQ(json["traits"]["tips"], 3);
  EXPECT_EQ(json["unit"], "m");
  EXPECT_GT(json["light"]["star"].get<double>(), 0.1);
}

} // namespace
} // namespace espalier
