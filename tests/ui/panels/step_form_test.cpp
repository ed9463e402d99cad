#include "core/pipeline/registry.h"
#include "ui/panels/density_curve.h"
#include "ui/panels/step_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QSignalSpy>
#include <QTest>
#include <QTranslator>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace espalier {
namespace {

/// The form of the contraction, for a plant of points 2 mm apart; its radii follow the density, by
/// default from 5 spacings to 10.
class AdaptiveForm : public testing::Test {
protected:
  AdaptiveForm() {
    PipelineOptions options;
    options.methods["contract"] = "adaptive_geodesic";
    form_.setScale({.spacing = 2, .height = 1000}, "mm");
    form_.choose(options);
    form_.setOpen(true);
    form_.show();
  }

  DensityCurve& curve() { return *form_.findChild<DensityCurve*>(); }
  QDoubleSpinBox& number(const char* name) { return *form_.findChild<QDoubleSpinBox*>(name); }
  std::map<std::string, Rule> settings() const {
    PipelineOptions options;
    form_.addTo(options);
    return options.settings["contract"];
  }

  StepForm form_{contractionStep(), 3};
  QSignalSpy changed_{&form_, &StepForm::changed};
};

TEST_F(AdaptiveForm, ShowsTheCurveOfItsRadii) {
  EXPECT_EQ(curve().curve(), (DensityCurve::Curve{.least = 10, .most = 20, .exponent = 1}));
  EXPECT_GE(curve().width(), 200);
  EXPECT_LT(curve().mapTo(&form_, QPoint()).y(), number("least_radius").mapTo(&form_, QPoint()).y())
      << "it stands above its numbers";
}

TEST_F(AdaptiveForm, HasACurveThatFollowsTheNumbers) {
  number("least_radius").setValue(8);
  number("curve").setValue(2);
  EXPECT_EQ(curve().curve(), (DensityCurve::Curve{.least = 8, .most = 20, .exponent = 2}));
  EXPECT_EQ(changed_.size(), 2);
}

TEST_F(AdaptiveForm, HasNumbersThatFollowTheCurve) {
  QTest::keyClick(&curve(), Qt::Key_Up);
  EXPECT_EQ(changed_.size(), 1) << "one number";
  EXPECT_GT(curve().curve().least, 10);
  EXPECT_NEAR(number("least_radius").value(), curve().curve().least, 1e-9);
  ASSERT_EQ(settings().size(), 1U) << "the others stay at their rules";
  EXPECT_EQ(settings().at("least_radius"), fixedAt(curve().curve().least));
  QTest::keyClick(&curve(), Qt::Key_Down);
  EXPECT_TRUE(settings().empty()) << "back at the default it follows the rule";
}

TEST_F(AdaptiveForm, TakesAWholeNumberByADoubleClick) {
  auto* line = number("least_radius").findChild<QLineEdit*>();
  QTest::mouseDClick(line, Qt::LeftButton);
  EXPECT_EQ(line->selectedText(), number("least_radius").cleanText());
}

TEST_F(AdaptiveForm, HasACurveForEachPlant) {
  form_.setScale({.spacing = 0.5, .height = 1000}, "cm");
  EXPECT_EQ(curve().curve(), (DensityCurve::Curve{.least = 2.5, .most = 5, .exponent = 1}));
}

TEST_F(AdaptiveForm, KeepsTheDensitiesForAnotherMethodThatHasACurve) {
  const QImage without = curve().grab().toImage();
  form_.setDensities({0.3F, 0.31F, 0.32F});
  EXPECT_NE(curve().grab().toImage(), without);
  PipelineOptions options;
  options.methods["contract"] = "geodesic_centroid";
  form_.choose(options);
  EXPECT_EQ(form_.findChild<DensityCurve*>(), nullptr);
  options.methods["contract"] = "adaptive_geodesic";
  form_.choose(options);
  EXPECT_NE(curve().grab().toImage(), without);
}

TEST_F(AdaptiveForm, KeepsItsFieldsForOtherValuesOfTheSameMethod) {
  const QPointer<QDoubleSpinBox> field = &number("least_radius");
  field->setValue(8);
  PipelineOptions options;
  options.methods["contract"] = "adaptive_geodesic";
  options.settings["contract"]["curve"] = fixedAt(2);
  form_.choose(options);
  EXPECT_EQ(field.data(), &number("least_radius"));
  EXPECT_EQ(settings(), options.settings["contract"]);
  EXPECT_EQ(curve().curve(), (DensityCurve::Curve{.least = 10, .most = 20, .exponent = 2}));
  EXPECT_EQ(changed_.size(), 1) << "by the number, not by what it is given";
}

/// To a language in which all that core marks is written in brackets.
class BracketTranslator : public QTranslator {
public:
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* text, const char* /*hint*/,
                    int /*count*/) const override {
    return std::string_view(context) == "espalier::Shown" ? QStringLiteral("[%1]").arg(text)
                                                          : QString();
  }
};

TEST(StepForm, ShowsMethodsAndOptionsInTheLanguageOfTheWindow) {
  BracketTranslator translator; // its destructor removes it
  QCoreApplication::installTranslator(&translator);
  const StepForm form(contractionStep(), 3);
  EXPECT_EQ(form.findChild<QComboBox*>()->currentText(), "[Geodesic centroids]");
  const auto labels = form.findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* each) {
    return each->text() == "[Radius]" && each->toolTip().contains("[Each point moves");
  }));
}

} // namespace
} // namespace espalier
