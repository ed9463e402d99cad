#include "core/pipeline/preset.h"
#include "core/pipeline/presets.h"
#include "tests/app/window/project_fixture.h"
#include "tests/app/window/read_entry.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"

#include <QAction>
#include <QInputDialog>
#include <QMenu>

#include <algorithm>
#include <fstream>

namespace espalier {
namespace {

/// The settings of all steps as a whole, in the real window.
struct PresetTest : test::ProjectWindowTest {
  PresetTest() { open({writeScan("plant.xyz")}); }
  [[nodiscard]] PipelineOptions shown() { return window().findChild<PipelinePanel*>()->options(); }
  void choose(const QString& id, const QString& file) {
    answer(chooseFile(file), [&] { action(id).trigger(); });
  }
  QString written(const QString& name, const std::string& text) {
    std::ofstream(path(name).toStdString()) << text;
    return path(name);
  }
};

TEST_F(PresetTest, OfTheThesisIsShownInTheForms) {
  action("preset_thesis").trigger();
  EXPECT_EQ(shown(), presetNamed("thesis")->options) << "lengths stay rules";
  action("preset_default").trigger();
  EXPECT_EQ(shown(), PipelineOptions());
}

TEST_F(PresetTest, GivesBackWhatItReplaced) {
  action("preset_default").trigger();
  EXPECT_FALSE(window().banner().isVisible()) << "nothing was set";
  PipelineOptions mine;
  mine.set("contract.radius=0.144");
  window().findChild<PipelinePanel*>()->setOptions(mine);
  action("preset_thesis").trigger();
  EXPECT_TRUE(
      window().banner().text().contains("What is set otherwise now: Thin: none; Contract: "))
      << window().banner().text().toStdString();
  clickButton("banner_action");
  EXPECT_EQ(shown(), mine);
}

TEST_F(PresetTest, MayHoldAValueThatIsOutOfRangeOfThisScan) {
  PipelineOptions kept = presetNamed("thesis")->options; // its contraction follows densities
  kept.set("contract.density_radius=1000000");
  window().findChild<PipelinePanel*>()->setOptions(kept);
  waitForJob();
  EXPECT_EQ(shown(), kept);
}

TEST_F(PresetTest, IsSavedAndOpenedAgain) {
  action("preset_thesis").trigger();
  choose("save_preset", path("mine.json"));
  EXPECT_TRUE(window().banner().text().contains("mine.json"));
  action("preset_default").trigger();
  choose("open_preset", path("mine.json"));
  EXPECT_EQ(shown(), presetNamed("thesis")->options);
}

TEST_F(PresetTest, IsKeptUnderANameUntilItIsForgotten) {
  action("preset_thesis").trigger();
  answer(
      [](QDialog& dialog) {
        dynamic_cast<QInputDialog&>(dialog).setTextValue("Apple & pear");
        dialog.accept();
      },
      [&] { action("keep_preset").trigger(); });
  action("preset_default").trigger();
  restart();
  open({path("plant.xyz")});
  const auto chosen = [&](const QString& text) {
    auto& menu = find<QMenu>("presets");
    emit menu.aboutToShow();
    QList<QAction*> all = menu.actions();
    for (const QMenu* part : menu.findChildren<QMenu*>())
      all.append(part->actions());
    const auto found = std::ranges::find(all, text, test::asRead);
    if (found == all.end()) return false;
    (*found)->trigger();
    return true;
  };
  EXPECT_TRUE(chosen("Settings: Apple & pear"));
  EXPECT_EQ(shown(), presetNamed("thesis")->options);
  EXPECT_TRUE(chosen("Apple & pear")) << "in the menu Forget";
  EXPECT_FALSE(chosen("Settings: Apple & pear"));
}

TEST_F(PresetTest, AFileThatIsNoneChangesNothing) {
  action("preset_thesis").trigger();
  choose("open_preset", written("broken.json", "{\n\"contract\": {\"radius\": \"wide\"}}"));
  EXPECT_TRUE(window().banner().text().contains("broken.json, line 2"))
      << window().banner().text().toStdString();
  EXPECT_EQ(shown(), presetNamed("thesis")->options);
}

TEST_F(PresetTest, GoesIntoTheProject) {
  const QString file = saveProject("plant.espalier");
  action("preset_thesis").trigger();
  window().close();
  restart();
  open({file});
  EXPECT_EQ(shown(), presetNamed("thesis")->options);
}

} // namespace
} // namespace espalier
