#pragma once

#include "app/window/preview/preview_flow.h"
#include "tests/app/window/window_fixture.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/panels/step_form.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QTest>
#include <QToolButton>

#include <algorithm>

namespace espalier::test {

/// Over the scan of a trunk of 2 m with three branches.
class PreviewTest : public WindowTest {
protected:
  PreviewTest() {
    open({writeScan("scan.xyz")});
    action("view_front").trigger();
    waitForView();
  }

  [[nodiscard]] PipelinePanel& panel() { return *window().findChild<PipelinePanel*>(); }
  [[nodiscard]] StepForm& step(const std::string& name) {
    const auto& steps = panel().steps();
    return **std::ranges::find_if(steps, [&](StepForm* form) { return form->step().name == name; });
  }
  [[nodiscard]] QDoubleSpinBox& number(const std::string& stepName, const QString& option) {
    return *step(stepName).findChild<QDoubleSpinBox*>(option);
  }
  void type(const std::string& stepName, const QString& option, double value) {
    QDoubleSpinBox& box = number(stepName, option);
    box.setFocus(); // else digits are keys of the plant
    box.selectAll();
    QTest::keyClicks(&box, QLocale().toString(value, 'g', 6).remove(QLocale().groupSeparator()));
    QTest::keyClick(&box, Qt::Key_Return);
  }
  [[nodiscard]] const std::optional<Outcome>& shown() {
    return window().part<PreviewFlow>().shown();
  }
  /// Until the preview is of the whole scan, and nothing runs.
  void waitForPreview() {
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return shown() && !shown()->within && !window().part<PreviewFlow>().isBusy(); },
        patience));
  }
  void turnOn() {
    key(Qt::Key_L, Qt::ControlModifier);
    waitForPreview();
  }
  void press(const QString& name) {
    auto& button = find<QToolButton>(name);
    QTest::mouseClick(&button, Qt::LeftButton);
  }
  [[nodiscard]] double radiusOf(const Outcome& outcome) {
    return outcome.options.settings.at("contract").at("radius").value({});
  }
};

} // namespace espalier::test
