#include "app/window/frame/action_set.h"
#include "app/window/view/view_text.h"
#include "core/base/error.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/step_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>

namespace espalier {
namespace {

using test::ProjectWindowTest;

TEST_F(ProjectWindowTest, KeepsTheOptionsOfThePipeline) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  auto& radius = *find<QWidget>("step_contract").findChild<QDoubleSpinBox*>("radius");
  radius.setValue(1.5 * radius.value());
  auto& method = *find<QWidget>("step_clean").findChild<QComboBox*>();
  method.setCurrentIndex(1);
  emit method.activated(1);
  const PipelineOptions chosen = options();
  EXPECT_EQ(chosen.methods.size(), 1U);
  EXPECT_EQ(chosen.settings.at("contract").size(), 1U);
  window().close();
  restart();
  EXPECT_EQ(options(), PipelineOptions()) << "each plant begins with the rules";
  open({file});
  EXPECT_EQ(options(), chosen);
  EXPECT_EQ(find<QWidget>("step_contract").findChild<QDoubleSpinBox*>("radius")->value(),
            chosen.settings.at("contract").at("radius").fixed)
      << "the form shows it";
  open({writeScan("other.xyz")});
  EXPECT_EQ(options(), PipelineOptions()) << "another plant";
}

TEST_F(ProjectWindowTest, ShowsWhichStepsThePlantWasMadeWithWhenItIsOpenedAgain) {
  using State = StepForm::State;
  const auto state = [this](const char* step) {
    return dynamic_cast<StepForm&>(find<QWidget>(step)).state();
  };
  open({writeScan("plant.xyz")});
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  const QString file = saveProject("plant.espalier");
  window().close();
  restart();
  open({file});
  EXPECT_EQ(state("step_clean"), State::done);
  EXPECT_EQ(state("step_radius"), State::done);
  auto& radius = *find<QWidget>("step_contract").findChild<QDoubleSpinBox*>("radius");
  radius.setValue(1.5 * radius.value());
  EXPECT_EQ(state("step_clean"), State::done);
  EXPECT_EQ(state("step_contract"), State::stale);
  window().close();
  restart();
  open({file});
  EXPECT_EQ(state("step_clean"), State::done);
  EXPECT_EQ(state("step_contract"), State::stale);
  EXPECT_EQ(state("step_radius"), State::stale);
  open({path("plant.xyz"), writeFork("fork.mtg")});
  EXPECT_EQ(state("step_clean"), State::idle) << "a structure of a file was made by other means";
}

TEST_F(ProjectWindowTest, KeepsOptionsWhileTheScanIsMissing) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  auto& radius = *find<QWidget>("step_contract").findChild<QDoubleSpinBox*>("radius");
  radius.setValue(1.5 * radius.value());
  const PipelineOptions chosen = options();
  window().close();
  QFile::rename(path("plant.xyz"), path("hidden"));
  ASSERT_TRUE(QFile::resize(path("hidden"), 10));
  restart();
  open({file});
  document().setUnit(LengthUnit::millimeter);
  EXPECT_EQ(options(), chosen) << "not pressed into the range of no plant";
}

TEST_F(ProjectWindowTest, OpensAPlantWhoseOptionsAreOfAnotherProgram) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  window().close();
  Project::open(toPath(file), Access::readWrite)
      .setDocument("pipeline", R"({"contract": {"magic": 1}})");
  restart();
  open({file});
  EXPECT_EQ(document().skeleton().size(), 5U);
  EXPECT_TRUE(window().banner().isError());
  EXPECT_EQ(options(), PipelineOptions());
  setRadius(0.4);
  window().close();
  EXPECT_TRUE(Project::open(toPath(file), Access::readOnly).document("pipeline").find("magic") !=
              std::string::npos)
      << "for that program";
}

TEST_F(ProjectWindowTest, KeepsTheViewAndOpensItWithoutAJump) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  action("view_top").trigger();
  action("parallel").trigger();
  action("layer_points").setChecked(false);
  action("point_size_4").trigger();
  action("color_uniform").trigger();
  waitForView();
  view().setPivot({0.2, 0.1, 0.5});
  waitForView();
  const Camera camera = view().camera();
  window().close();
  restart();
  EXPECT_TRUE(action("layer_points").isChecked()) << "what one plant hides is shown of the next";
  action("perspective").trigger();
  action("point_size_1").trigger();
  action("color_height").trigger();
  window().open({file});
  waitForJob();
  EXPECT_EQ(view().camera(), camera);
  waitForView();
  EXPECT_EQ(view().camera(), camera);
  EXPECT_FALSE(action("layer_points").isChecked());
  EXPECT_TRUE(action("parallel").isChecked());
  EXPECT_TRUE(action("point_size_4").isChecked());
  EXPECT_TRUE(action("color_uniform").isChecked());
  action("layer_skeleton").setChecked(false);
  open({writeScan("other.xyz")});
  EXPECT_TRUE(action("layer_points").isChecked());
  EXPECT_TRUE(action("layer_skeleton").isChecked());
  EXPECT_TRUE(action("point_size_1").isChecked());
  EXPECT_EQ(view().camera().projection, Projection::perspective);
}

TEST_F(ProjectWindowTest, KeepsTheScalesOfColors) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  ColorScales chosen = view().colorScales();
  chosen.ranges["color_height"] = {0.25, 1.5};
  view().setColorScales(chosen);
  action("node_map_cividis").trigger();
  chosen.nodes = ColorMap::cividis;
  window().close();
  restart();
  action("node_map_gray").trigger();
  open({file});
  EXPECT_EQ(view().colorScales(), chosen);
  EXPECT_TRUE(action("node_map_cividis").isChecked());
  action("usual_color_ranges").trigger();
  EXPECT_TRUE(view().colorScales().ranges.empty());
  open({writeScan("other.xyz")});
  EXPECT_TRUE(view().colorScales().ranges.empty()) << "another plant";
  EXPECT_TRUE(action("node_map_gray").isChecked()) << "as it was chosen for all plants";
}

TEST_F(ProjectWindowTest, KeepsWhatIsClipped) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  const Clip clip{.slab = Clip::Slab{0.25, 0.5},
                  .box = Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1))};
  view().setClip(clip);
  view().setDepthFade(0.5);
  window().close();
  restart();
  open({file});
  EXPECT_EQ(view().clip(), clip);
  EXPECT_EQ(view().depthFade(), 0.5);
  EXPECT_TRUE(action("show_all").isEnabled());
  open({writeScan("other.xyz")});
  EXPECT_TRUE(view().clip().isAll()) << "another plant";
  EXPECT_EQ(view().depthFade(), 0);
}

TEST_F(ProjectWindowTest, AsksForColorsBeforeTheirRangeIsTyped) {
  open({writeScan("plant.xyz")});
  action("color_uniform").trigger();
  QString refusal;
  QObject::connect(&window().actionSet(), &ActionSet::refused, &window(),
                   [&](const QString& reason) { refusal = reason; });
  action("color_range").trigger();
  EXPECT_TRUE(refusal.contains("color points", Qt::CaseInsensitive)) << refusal.toStdString();
}

TEST_F(ProjectWindowTest, ShowsAllOfAPlantWhoseViewCannotBeRead) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const Camera whole = view().camera();
  const QString file = saveProject("plant.espalier");
  window().close();
  Project::open(toPath(file), Access::readWrite)
      .setDocument("view", R"({"camera": {"focus": [0, 0, 1e999], "distance": -1}})");
  restart();
  open({file});
  EXPECT_TRUE(window().banner().isError());
  EXPECT_NEAR(view().camera().distance, whole.distance, 1e-9);
}

TEST(ViewText, BringsAViewBack) {
  const ViewText view{.camera = {.focus = {1.0 / 3, 648'250.001, -2},
                                 .pivot = {0, 1, 2},
                                 .distance = 0.1,
                                 .yaw = -0.3,
                                 .pitch = 1.2,
                                 .projection = Projection::parallel},
                      .layers = {{"layer_points", false}},
                      .choices = {{"color", "color_rgb"}, {"point_size", "point_size_3"}},
                      .ranges = {{"color_height", {-1.0 / 3, 1e9}}},
                      .clip = {.slab = Clip::Slab{0.1, 0.9}, .box = {}},
                      .depthFade = 0.25};
  const ViewText back = viewFrom(textOf(view));
  EXPECT_EQ(back.camera, view.camera) << "to the last bit";
  EXPECT_EQ(back.layers, view.layers);
  EXPECT_EQ(back.choices, view.choices);
  EXPECT_EQ(back.ranges, view.ranges);
  EXPECT_EQ(back.clip, view.clip);
  EXPECT_EQ(back.depthFade, view.depthFade);
}

TEST(ViewText, RefusesARangeThatIsNone) {
  for (const char* range : {"[1, 1]", "[2, 1]", "[1]", "[\"a\", 2]"}) {
    std::string text = textOf({.camera = {.distance = 2}});
    text.insert(1, R"("ranges": {"color_height": )" + std::string(range) + "},");
    EXPECT_THROW((void)viewFrom(text), Error) << text;
  }
}

TEST(ViewText, RefusesACameraThatCannotBe) {
  for (const char* camera :
       {"", R"("distance": 0)", R"("distance": "far")", R"("focus": [1, 2])", R"("pitch": 2)"}) {
    std::string text = textOf({.camera = {.distance = 2}});
    if (*camera == 0)
      text = "{}";
    else // of two equal names the last counts
      text.insert(text.find('}'), std::string(",") + camera);
    EXPECT_THROW((void)viewFrom(text), Error) << text;
  }
}

} // namespace
} // namespace espalier
