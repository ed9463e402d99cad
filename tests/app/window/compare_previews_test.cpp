// Comparing previews, judging them by numbers, and sweeps, by mouse and keys in the real window.
#include "app/window/preview/states_flow.h"
#include "core/evaluate/differences/differences.h"
#include "tests/app/window/preview_fixture.h"
#include "ui/panels/judge_table.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/status_line.h"
#include "ui/panels/sweep_strip.h"
#include "ui/plots/histogram_view.h"

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>

#include <algorithm>

namespace espalier {
namespace {

using test::PreviewTest;

TEST_F(PreviewTest, ComparesWithWhatWasKeptAsA) {
  turnOn();
  key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  type("contract", "radius", 0.12);
  waitForPreview();
  key(Qt::Key_9, Qt::ControlModifier);
  EXPECT_EQ(view().divider(), 0.5);
  auto& divider = find<QWidget>("divider");
  EXPECT_TRUE(divider.isVisible());
  const QPoint grip = divider.rect().center();
  QTest::mousePress(&divider, Qt::LeftButton, {}, grip);
  QMouseEvent move(QEvent::MouseMove, grip + QPoint(80, 0),
                   divider.mapToGlobal(grip + QPoint(80, 0)), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(&divider, &move);
  QTest::mouseRelease(&divider, Qt::LeftButton, {}, grip);
  EXPECT_NEAR(view().divider(), 0.5 + 80.0 / view().width(), 0.01);
  key(Qt::Key_9, Qt::ControlModifier);
  EXPECT_EQ(view().divider(), 0) << "as before";
  EXPECT_TRUE(action("compare_alone").isChecked());
  action("compare_two_views").trigger();
  EXPECT_EQ(view().divider(), 1) << "A in the first view, the preview in the second";
  EXPECT_EQ(find<PlantView>("second_view").divider(), 0);
  action("compare_alone").trigger();
  EXPECT_FALSE(action("two_views").isChecked()) << "which was there for the comparison";
  EXPECT_EQ(view().divider(), 0);
  view().setFocus();
  key(Qt::Key_Escape);
  EXPECT_EQ(view().divider(), 0) << "the plant, not A, fills the view";
  action("forget_a").trigger();
  EXPECT_EQ(view().divider(), 1);
}

TEST_F(PreviewTest, BlendsScannedAndContractedPoints) {
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  key(Qt::Key_7, Qt::ControlModifier);
  auto& slider = find<QSlider>("blend_slider");
  EXPECT_TRUE(slider.isVisible());
  const QImage contracted = view().picture({300, 200});
  QTest::keyClick(&slider, Qt::Key_Home);
  EXPECT_NE(view().picture({300, 200}), contracted);
  press("blend_ways");
  clickButton("blend_close");
  EXPECT_FALSE(slider.isVisible());
  EXPECT_FALSE(action("blend_points").isChecked());
}

TEST_F(PreviewTest, ColorsWhatItHasLostOfA) {
  turnOn();
  key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  action("color_state_differences").trigger();
  type("prune", "length", 2); // of three branches none is left
  waitForPreview();
  const Skeleton& now = *shown()->skeleton;
  const Skeleton& a = *window().part<StatesFlow>().kept()->skeleton;
  ASSERT_LT(now.size(), a.size());
  const auto& drawn = window().part<PreviewFlow>().drawn();
  ASSERT_TRUE(QTest::qWaitFor([&] { return drawn.has_value(); }, patience));
  EXPECT_GT(drawn->skeleton.size(), now.size());
  EXPECT_GT(std::ranges::count(drawn->colors.values, static_cast<float>(Difference::missed)), 3);
  action("color_state_differences").trigger();
  EXPECT_FALSE(drawn);
}

TEST_F(PreviewTest, JudgesByNumbersAndSelectsWhatIsMarked) {
  key(Qt::Key_F6, Qt::ShiftModifier);
  turnOn();
  auto& table = find<JudgeTable>("judge_table");
  ASSERT_TRUE(QTest::qWaitFor([&] { return table.rowCount() > 0; }, patience));
  EXPECT_TRUE(table.table().contains("Residual thickness")) << table.table().toStdString();
  EXPECT_TRUE(document().pointSelection().isEmpty());
  auto& histogram = find<QWidget>("judge_histogram");
  const QPoint from(histogram.width() / 2, histogram.height() / 2);
  const QPoint to(histogram.width() - 12, histogram.height() / 2);
  QTest::mousePress(&histogram, Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, to, histogram.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                   {});
  QApplication::sendEvent(&histogram, &move);
  QTest::mouseRelease(&histogram, Qt::LeftButton, {}, to);
  EXPECT_FALSE(document().pointSelection().isEmpty());
  EXPECT_LT(document().pointSelection().points().size(),
            std::size_t(document().scan()->cloud()->size()));
  QTest::keyClick(&histogram, Qt::Key_Escape);
  EXPECT_TRUE(document().pointSelection().isEmpty());
  for (int kind = 1; kind < find<QComboBox>("judge_kind").count(); ++kind)
    find<QComboBox>("judge_kind").setCurrentIndex(kind);
}

TEST_F(PreviewTest, MarksTheNumberOfTheTableInItsHistogram) {
  window().resize(1280, 800);
  key(Qt::Key_F6, Qt::ShiftModifier);
  turnOn();
  const auto& table = find<JudgeTable>("judge_table");
  const auto& histogram = find<HistogramView>("judge_histogram");
  ASSERT_TRUE(QTest::qWaitFor([&] { return histogram.plot().mark.has_value(); }, patience));
  EXPECT_EQ(table.item(0, 0)->text(), "Residual thickness [spacings]");
  EXPECT_TRUE(QTest::qWaitFor([&] { return table.height() >= table.heightForRows(); }, patience))
      << "no row is cut";
  EXPECT_EQ(histogram.plot().mark->text, "median " + table.item(0, 1)->text());
  find<QComboBox>("judge_kind").setCurrentText("Distance from the axis");
  EXPECT_FALSE(histogram.plot().mark) << "the number is not of these";
}

TEST_F(PreviewTest, NumbersFollowAtOnceWhatIsGoneAndWhatIsAskedFor) {
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  key(Qt::Key_F6, Qt::ShiftModifier);
  turnOn();
  const auto& table = find<JudgeTable>("judge_table");
  ASSERT_TRUE(QTest::qWaitFor([&] { return table.columnCount() == 3; }, patience));
  const auto& histogram = find<HistogramView>("judge_histogram");
  find<QComboBox>("judge_kind").setCurrentText("Displacement");
  EXPECT_EQ(histogram.plot().title, "Displacement") << "before its values are computed";
  EXPECT_TRUE(histogram.plot().bins.isEmpty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !histogram.plot().bins.isEmpty(); }, patience));
  view().setFocus();
  key(Qt::Key_Escape);
  EXPECT_FALSE(shown());
  ASSERT_EQ(table.columnCount(), 2);
  EXPECT_EQ(table.horizontalHeaderItem(1)->text(), "Plant");
}

TEST_F(PreviewTest, SweepsAnOptionAndTakesAValue) {
  key(Qt::Key_F7, Qt::ShiftModifier);
  find<QSpinBox>("sweep_count").setValue(3);
  EXPECT_EQ(find<QComboBox>("sweep_option").currentText(), "Contract: Radius");
  auto& from = find<QDoubleSpinBox>("sweep_from");
  auto& to = find<QDoubleSpinBox>("sweep_to");
  EXPECT_NEAR(to.value() / from.value(), 16, 0.5) << "from a quarter of the default to 4 times it";
  from.setValue(0.05);
  to.setValue(0.2);
  clickButton("sweep_run");
  auto& strip = find<SweepStrip>("sweep_strip");
  ASSERT_EQ(strip.cards().size(), 3U);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return std::ranges::none_of(strip.cards(),
                                    [](const SweepCard* card) { return card->item().isPending; });
      },
      patience));
  for (const SweepCard* card : strip.cards()) {
    EXPECT_FALSE(card->item().picture.isNull());
    EXPECT_GE(card->item().scores.size(), 4U);
  }
  EXPECT_TRUE(document().skeleton().isEmpty()) << "nothing of the plant has changed";
  EXPECT_TRUE(strip.cards()[1]->item().label.startsWith("0.1"));
  const QImage before = strip.cards()[1]->item().picture;
  action("view_left").trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return strip.cards()[1]->item().picture != before; }, patience))
      << "pictures follow the view";
  QTest::keyClick(strip.cards()[2], Qt::Key_Return);
  EXPECT_EQ(panel().options().settings.at("contract").at("radius"), fixedAt(0.2));
  EXPECT_TRUE(strip.cards()[2]->item().isCurrent);
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Set: Contract: Radius 0.2"))
      << window().statusLine().shownText().toStdString();
}

TEST_F(PreviewTest, AStoppedSweepSaysHowFarItCame) {
  key(Qt::Key_F7, Qt::ShiftModifier);
  find<QSpinBox>("sweep_count").setValue(12);
  clickButton("sweep_run");
  auto& strip = find<SweepStrip>("sweep_strip");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !strip.cards()[0]->item().isPending; }, patience));
  clickButton("sweep_run");
  const auto done = strip.cards().size();
  ASSERT_LT(done, 12U);
  EXPECT_EQ(find<QLabel>("sweep_note").text(),
            QString("Contract: Radius: stopped, %1 of 12 done").arg(done));
}

TEST_F(PreviewTest, SweepsOptionsOfTheMethodsThatAreShown) {
  key(Qt::Key_F7, Qt::ShiftModifier);
  auto& option = find<QComboBox>("sweep_option");
  option.setCurrentIndex(option.findData("contract.radius"));
  ASSERT_EQ(option.currentData(), "contract.radius");
  PipelineOptions other = panel().options();
  other.methods["contract"] = "none";
  panel().setOptions(other); // as a preset or a project does
  EXPECT_EQ(option.findData("contract.radius"), -1);
  clickButton("sweep_run");
  EXPECT_FALSE(find<SweepStrip>("sweep_strip").cards().empty());
}

TEST_F(PreviewTest, SweepsTheMethodsOfAStepAndTakesOne) {
  key(Qt::Key_F7, Qt::ShiftModifier);
  auto& option = find<QComboBox>("sweep_option");
  option.setCurrentIndex(option.findData("prune.method"));
  ASSERT_EQ(option.currentText(), "Prune: Method");
  EXPECT_FALSE(find<QDoubleSpinBox>("sweep_from").isEnabled()) << "all methods are tried";
  clickButton("sweep_run");
  auto& strip = find<SweepStrip>("sweep_strip");
  ASSERT_EQ(strip.cards().size(), stepNamed("prune").methods.size());
  EXPECT_TRUE(strip.cards()[0]->item().isCurrent);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return std::ranges::none_of(strip.cards(),
                                    [](const SweepCard* card) { return card->item().isPending; });
      },
      patience));
  EXPECT_FALSE(strip.cards()[0]->item().label.endsWith(", as set")) << "it has its defaults";
  QTest::keyClick(strip.cards()[1], Qt::Key_Return);
  EXPECT_EQ(panel().options().methods.at("prune"), stepNamed("prune").methods[1].name);
  EXPECT_TRUE(strip.cards()[1]->item().isCurrent);
  panel().setOptions({}); // as Escape does that drops a preview
  EXPECT_TRUE(strip.cards()[0]->item().isCurrent);
  EXPECT_FALSE(strip.cards()[1]->item().isCurrent);
}

TEST_F(PreviewTest, SweepsWithTheDefaultInTheMiddle) {
  key(Qt::Key_F7, Qt::ShiftModifier);
  find<QSpinBox>("sweep_count").setValue(3);
  clickButton("sweep_run");
  const auto& cards = find<SweepStrip>("sweep_strip").cards();
  ASSERT_EQ(cards.size(), 3U);
  EXPECT_TRUE(cards[1]->item().isCurrent) << "though nobody chose it";
  EXPECT_FALSE(cards[0]->item().isCurrent);
  auto* method = step("contract").findChild<QComboBox*>();
  method->setCurrentIndex(method->findData("adaptive_geodesic"));
  emit method->activated(method->currentIndex());
  EXPECT_TRUE(find<QComboBox>("sweep_option").currentText().startsWith("Contract:"))
      << "of the same step, though its method has no such radius";
}

TEST_F(PreviewTest, RecordsAChoiceInTheProjectAndTakesItBack) {
  EXPECT_FALSE(action("forget_choice").isEnabled());
  key(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(window().banner().isVisible()) << "nothing is compared yet";
  key(Qt::Key_F6, Qt::ShiftModifier);
  turnOn();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return find<JudgeTable>("judge_table").rowCount() > 0; }, patience));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { // refused until all numbers are there
        key(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
        return action("forget_choice").isEnabled();
      },
      patience));
  EXPECT_FALSE(window().banner().isVisible()) << "what it reported is mended";
  answer(chooseFile(path("plant.espalier")), [&] { action("save_project_as").trigger(); });
  waitForJob();
  restart();
  EXPECT_FALSE(action("forget_choice").isEnabled());
  open({path("plant.espalier")});
  EXPECT_TRUE(action("forget_choice").isEnabled()) << "the project has kept it";
  action("forget_choice").trigger();
  EXPECT_FALSE(action("forget_choice").isEnabled());
}

} // namespace
} // namespace espalier
