#include "ui/panels/measures_form.h"

#include <QLabel>
#include <QStringList>
#include <QToolButton>
#include <gtest/gtest.h>

#include <numbers>

namespace espalier {
namespace {

/// Of a plant of 2 m in two slabs, of which the upper shows no thickness.
ScanMeasures someMeasures() {
  ScanMeasures measures;
  measures.spacing = 0.005;
  measures.whole = {.points = 1000,
                    .spacing = Spread{0.002, 0.004, 0.008},
                    .scatter = 0.0021,
                    .thickness = Spread{0.005, 0.013, 0.062},
                    .measured = 0.84,
                    .arc = 1.5 * std::numbers::pi,
                    .gaps = {0.04, 0.048},
                    .foliage = 0.031};
  measures.slabs = {{.from = 0, .to = 1, .measures = measures.whole},
                    {.from = 1, .to = 2, .measures = measures.whole}};
  measures.slabs[1].measures.thickness.reset();
  return measures;
}

QString valueOf(const QString& name, const ScanMeasures& measures, LengthUnit unit) {
  for (const MeasureText& text : measureTexts(measures, unit))
    if (text.name == name) return text.value;
  return {};
}

QStringList shownIn(const QWidget& form) {
  QStringList texts;
  for (const auto* label : form.findChildren<QLabel*>())
    if (label->isVisibleTo(&form)) texts.append(label->text());
  return texts;
}

TEST(MeasuresForm, SaysWhatWasMeasuredInTheUnitOfThePlant) {
  const ScanMeasures measures = someMeasures();
  EXPECT_EQ(valueOf("Points apart", measures, LengthUnit::meter),
            "0.0040\u202fm (0.0020 to 0.0080)");
  EXPECT_EQ(valueOf("Scatter", measures, LengthUnit::meter), "0.0021\u202fm, 0.42 spacings");
  EXPECT_EQ(valueOf("Wood is thick", measures, LengthUnit::meter),
            "0.013\u202fm (0.0050 to 0.062)");
  EXPECT_EQ(valueOf("Seen around", measures, LengthUnit::meter), "270°");
  EXPECT_EQ(valueOf("Gaps", measures, LengthUnit::meter), "2, the widest 0.048\u202fm");
  EXPECT_EQ(valueOf("Foliage", measures, LengthUnit::meter), "3 % of the points");
  EXPECT_EQ(valueOf("Scatter", measures, LengthUnit::unknown), "0.0021, 0.42 spacings");
}

TEST(MeasuresForm, LeavesOutWhatThePointsDoNotShow) {
  ScanMeasures measures = someMeasures();
  measures.whole.arc.reset();
  measures.whole.thickness.reset();
  measures.whole.gaps.clear();
  EXPECT_EQ(valueOf("Seen around", measures, LengthUnit::meter), "");
  EXPECT_EQ(valueOf("Wood is thick", measures, LengthUnit::meter), "");
  EXPECT_EQ(valueOf("Gaps", measures, LengthUnit::meter), "none");
}

TEST(MeasuresForm, IsALineUntilItIsOpened) {
  MeasuresForm form;
  EXPECT_TRUE(form.isHidden()) << "there is no scan";
  form.showMeasuring();
  EXPECT_FALSE(form.isHidden());
  EXPECT_TRUE(shownIn(form).contains("being measured…"));
  form.showMeasured(someMeasures(), LengthUnit::meter);
  EXPECT_EQ(shownIn(form),
            QStringList("points 0.0050\u202fm apart, wood 0.013\u202fm, scatter 0.0021\u202fm"));
  form.findChild<QToolButton*>()->click();
  const QStringList opened = shownIn(form);
  EXPECT_TRUE(opened.contains("Seen around"));
  EXPECT_TRUE(opened.contains("270°"));
  EXPECT_EQ(opened.count("3 %"), 2) << "a row per slab";
  EXPECT_EQ(opened.count("–"), 1) << "the upper slab shows no thickness";
  form.showMeasuring();
  EXPECT_EQ(shownIn(form), QStringList("being measured…")) << "what was shown is no longer true";
}

} // namespace
} // namespace espalier
