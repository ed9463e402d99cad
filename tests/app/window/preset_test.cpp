#include "core/pipeline/preset.h"
#include "core/pipeline/presets.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"

#include <QAction>

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

TEST_F(PresetTest, IsSavedAndOpenedAgain) {
  action("preset_thesis").trigger();
  choose("save_preset", path("mine.json"));
  EXPECT_TRUE(window().banner().text().contains("mine.json"));
  action("preset_default").trigger();
  choose("open_preset", path("mine.json"));
  EXPECT_EQ(shown(), presetNamed("thesis")->options);
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
