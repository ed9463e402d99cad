#include "app/window/evaluate/reference_text.h"
#include "app/window/files/load_files.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "tests/app/window/project_fixture.h"
#include "tests/ui/view/pictures.h"
#include "ui/panels/status_line.h"
#include "ui/view/palette.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QTest>
#include <QToolButton>

namespace espalier {
namespace {

/// The fork as plant, and as reference another that lies beside it.
struct ReferenceWindowTest : test::ProjectWindowTest {
  QString writeReference() const {
    Skeleton plant = test::fork(2);
    for (const NodeId id : plant.ids())
      plant.setPosition(id, plant[id].position + Eigen::Vector3d(0, 0, 3));
    writeStructure(toPath(path("expert.mtg")), plant);
    return path("expert.mtg");
  }
  void load(const QString& file) {
    answer(chooseFile(file), [this] { action("load_reference").trigger(); });
    waitForJob();
    waitForView();
  }
  void drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window(), &enter);
    QDropEvent event(QPointF(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window(), &event);
    QTest::qWait(0);
  }
  [[nodiscard]] bool isShown() {
    const QImage picture = view().picture({400, 300});
    return test::countPixels(picture, palette(true).reference) > 20 ||
           test::countPixels(picture, palette(false).reference) > 20;
  }
};

TEST_F(ReferenceWindowTest, OffersByOneClickTheReferenceThatLiesBesideTheScan) {
  const QString scan = writeScan("plant.xyz");
  open({scan});
  EXPECT_FALSE(action("load_reference_beside").isVisible()) << "there is none";
  EXPECT_EQ(action("load_reference_beside").text(), "Load Reference Beside the Scan");
  const QString reference = writeFork("plant.mtg");
  open({scan});
  key(Qt::Key_F5);
  auto& button = find<QToolButton>("evaluation_beside");
  ASSERT_TRUE(button.isVisible());
  EXPECT_EQ(button.text(), "Compare with plant.mtg");
  QTest::mouseClick(&button, Qt::LeftButton);
  waitForJob();
  EXPECT_TRUE(action("layer_reference").isVisible());
  EXPECT_FALSE(action("load_reference_beside").isVisible()) << "it is loaded";
  action("remove_reference").trigger();
  EXPECT_TRUE(action("load_reference_beside").isVisible());
  open({scan, reference});
  EXPECT_FALSE(action("load_reference_beside").isVisible()) << "it is the plant itself";
}

TEST_F(ReferenceWindowTest, ShowsAReferenceBesideThePlantAndPutsItAway) {
  open({writeFork("fork.mtg")});
  EXPECT_FALSE(action("remove_reference").isEnabled());
  EXPECT_FALSE(action("layer_reference").isVisible()) << "there is nothing to switch";
  load(writeReference());
  view().frameAll();
  EXPECT_TRUE(isShown());
  EXPECT_EQ(document().skeleton().size(), 5U) << "the plant stays";
  EXPECT_EQ(document().undoStack().count(), 0) << "it is no edit";
  EXPECT_TRUE(action("layer_reference").isVisible());
  key(Qt::Key_6, Qt::ControlModifier);
  EXPECT_FALSE(isShown());
  key(Qt::Key_6, Qt::ControlModifier);
  EXPECT_TRUE(isShown());
  action("remove_reference").trigger();
  EXPECT_FALSE(isShown());
  EXPECT_FALSE(action("remove_reference").isEnabled());
}

TEST_F(ReferenceWindowTest, PicksNothingOfTheReference) {
  open({writeFork("fork.mtg")});
  load(writeReference());
  view().frameAll();
  waitForView();
  const auto place = view().project({0, 0, 4}); // its branching
  ASSERT_TRUE(place);
  EXPECT_EQ(view().pick(*place).node, std::nullopt);
}

TEST_F(ReferenceWindowTest, ComesBackWithTheProject) {
  open({writeFork("fork.mtg")});
  load(writeReference());
  const QString file = saveProject("plant.espalier");
  window().close();
  QFile::remove(path("expert.mtg")); // the project has it
  restart();
  open({file});
  view().frameAll();
  EXPECT_TRUE(isShown());
  action("remove_reference").trigger();
  window().close();
  restart();
  open({file});
  EXPECT_FALSE(action("remove_reference").isEnabled()) << "to remove it is kept, too";
}

TEST_F(ReferenceWindowTest, GoesWithThePlant) {
  open({writeFork("fork.mtg")});
  load(writeReference());
  document().undoStack().setClean();
  action("close_plant").trigger();
  EXPECT_FALSE(action("remove_reference").isEnabled());
}

TEST_F(ReferenceWindowTest, TakesThePlantOfAnotherProject) {
  open({writeFork("fork.mtg")});
  const QString file = saveProject("colleague.espalier");
  open({writeReference()});
  load(file);
  EXPECT_TRUE(action("remove_reference").isEnabled()) << message().toStdString();
}

TEST_F(ReferenceWindowTest, RefusesWhatCannotBeComparedWith) {
  open({writeFork("fork.mtg")});
  writeStructure(toPath(path("dot.mtg")), test::stick(1));
  load(path("dot.mtg"));
  EXPECT_TRUE(message().startsWith("dot.mtg has no length")) << message().toStdString();
  load(writeScan("plant.xyz"));
  EXPECT_EQ(message(), "plant.xyz is a scan: a reference is a structure, as an MTG");
  EXPECT_FALSE(action("remove_reference").isEnabled());
  EXPECT_TRUE(window().banner().isVisible());
  load(writeReference());
  EXPECT_FALSE(window().banner().isVisible()) << "what was said of another leaves";
}

TEST_F(ReferenceWindowTest, AsksWhatADroppedStructureIsToBe) {
  drop(writeFork("fork.mtg"));
  waitForJob();
  EXPECT_EQ(document().skeleton().size(), 5U) << "without a plant there is nothing to ask";
  answer(press("Load as Reference"), [this] { drop(writeReference()); });
  waitForJob();
  EXPECT_TRUE(action("remove_reference").isEnabled());
  EXPECT_EQ(document().skeleton().size(), 5U);
  answer(press("Cancel"), [this] { drop(path("expert.mtg")); });
  EXPECT_FALSE(window().jobs().isBusy());
  answer(press("Open"), [this] { drop(path("expert.mtg")); });
  waitForJob();
  EXPECT_EQ(document().skeleton().size(), 4U);
}

TEST(ReferenceText, ComesBackAsItWas) {
  Skeleton plant = test::fork(3);
  plant.setPosition(NodeId{2}, {0.1, 1.0 / 3, -2e-7});
  const Reference reference{plant, "/home/ä/expert.mtg"};
  EXPECT_EQ(referenceFrom(textOf(reference)), reference);
  const Reference version{.skeleton = plant, .path = "before pruning", .isVersion = true};
  EXPECT_EQ(referenceFrom(textOf(version)), version);
  const Reference inPlace{.skeleton = plant,
                          .path = "before pruning",
                          .isVersion = true,
                          .before = {{.skeleton = plant, .path = "b.espalier", .isOfScan = true}}};
  EXPECT_EQ(referenceFrom(textOf(inPlace)), inPlace);
  EXPECT_EQ(textOf(Reference{}), "");
  EXPECT_EQ(referenceFrom(""), Reference{});
}

TEST(ReferenceText, IsRefusedIfItIsNone) {
  for (const char* nodes :
       {"[]", "[1]", R"([[-1, "<", 0, 0, 0]])", R"([[0, "<", 0, 0, 0, 0]])",
        R"([[-1, "<", 0, 0, "a", 0]])", R"([[-1, "/", 0, 0, 0, 0]])", R"([[-1, "<", 0, 0, 0, -1]])",
        R"([[-1, "<", 0, 0, 0, 0], [1, "<", 0, 0, 0, 0]])"})
    EXPECT_THROW(static_cast<void>(referenceFrom(std::string("{\"nodes\": ") + nodes + "}")), Error)
        << nodes;
  EXPECT_THROW(static_cast<void>(referenceFrom("nonsense")), Error);
}

} // namespace
} // namespace espalier
