#include "ui/panels/option_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

namespace espalier {
namespace {

/// A form of one option.
struct Form {
  explicit Form(const Option& option) : field(OptionField::make(option, grid, widget)) {}

  QWidget widget;
  QGridLayout& grid = *new QGridLayout(&widget);
  OptionField* field;
};

Option flow() {
  return {.name = "flow",
          .label = "Flow",
          .kind = OptionKind::choice,
          .rule = fixedAt(1),
          .maximum = 1,
          .help = "How it flows.",
          .choices = {{"slow", "Slowly"}, {"fast", "Fast"}}};
}

Option dry() {
  return {.name = "dry",
          .label = "Dry",
          .kind = OptionKind::flag,
          .rule = fixedAt(1),
          .maximum = 1,
          .help = "Whether it is dry."};
}

TEST(OptionField, OfAChoiceIsAListOfItsWords) {
  Form form(flow());
  auto& words = *form.widget.findChild<QComboBox*>("flow");
  ASSERT_EQ(words.count(), 2);
  EXPECT_EQ(words.currentText(), "Fast"); // the default
  EXPECT_TRUE(words.toolTip().contains("Default: fast"));
  const QSignalSpy changed(form.field, &OptionField::changed);
  QTest::keyClick(&words, Qt::Key_Up);
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(form.field->chosen(), fixedAt(0));
  form.widget.findChild<QToolButton*>()->click(); // back
  EXPECT_FALSE(form.field->chosen());
  EXPECT_EQ(words.currentText(), "Fast");
}

TEST(OptionField, NamesTheRuleThatItsNumberFollowsFrom) {
  Form form({.name = "reach",
             .label = "Reach",
             .kind = OptionKind::length,
             .rule = spacings(8),
             .minimum = 1,
             .maximum = 100,
             .help = "How far."});
  form.field->setScale({.spacing = 0.5, .height = 100}, "m");
  form.field->choose(spacings(6));
  EXPECT_EQ(form.widget.findChild<QDoubleSpinBox*>("reach")->value(), 3);
  const auto& reset = *form.widget.findChild<QToolButton*>();
  EXPECT_EQ(reset.toolTip(), "Set to 6 point spacings: back to the default");
  form.field->choose(3.5);
  EXPECT_EQ(reset.toolTip(), "Back to the default");
}

TEST(OptionField, OfAFlagIsABoxToCheck) {
  Form form(dry());
  auto& box = *form.widget.findChild<QCheckBox*>("dry");
  EXPECT_TRUE(box.isChecked());
  EXPECT_EQ(box.text(), "Dry");
  box.click();
  EXPECT_EQ(form.field->chosen(), fixedAt(0));
  form.field->choose(std::nullopt);
  EXPECT_TRUE(box.isChecked());
}

TEST(OptionField, OfANumberFollowsTheScaleOfThePlant) {
  Form form({.name = "reach",
             .label = "Reach",
             .kind = OptionKind::length,
             .rule = spacings(4),
             .minimum = 1,
             .maximum = 10,
             .help = "How far."});
  form.field->setScale({.spacing = 2, .height = 100}, "mm");
  auto& number = *form.widget.findChild<QDoubleSpinBox*>("reach");
  EXPECT_EQ(number.value(), 8);
  EXPECT_EQ(number.maximum(), 20);
  number.setValue(12);
  EXPECT_EQ(form.field->chosen(), fixedAt(12));
  form.field->choose(spacings(3));
  EXPECT_EQ(number.value(), 6);
  form.field->setScale({.spacing = 0.5, .height = 100}, "m");
  EXPECT_EQ(number.value(), 1.5) << "another plant, the same rule";
  EXPECT_EQ(form.field->chosen(), spacings(3));
  number.selectAll();
  QTest::keyClicks(&number, "4 sp");
  QTest::keyClick(&number, Qt::Key_Return);
  EXPECT_EQ(number.value(), 2);
  EXPECT_EQ(form.field->chosen(), spacings(4)) << "as it was typed";
  form.field->choose(fixedAt(2));
  number.selectAll();
  QTest::keyClicks(&number, "4 sp");
  QTest::keyClick(&number, Qt::Key_Return);
  EXPECT_EQ(form.field->chosen(), spacings(4)) << "though the number is as it was";
  number.selectAll();
  QTest::keyClicks(&number, "2.5");
  QTest::keyClick(&number, Qt::Key_Return);
  EXPECT_EQ(form.field->chosen(), fixedAt(2.5));
  form.field->choose(fixedAt(100));
  form.field->setScale({.spacing = 2, .height = 100}, "mm");
  EXPECT_EQ(form.field->chosen(), fixedAt(100)) << "as it was chosen";
}

TEST(OptionField, OfANumberSaysWhatItMayBeWhereItIsSomethingElse) {
  Form form({.name = "reach",
             .label = "Reach",
             .kind = OptionKind::length,
             .rule = spacings(4),
             .minimum = 1,
             .maximum = 10,
             .help = "How far."});
  const auto& label = *form.widget.findChild<QLabel*>();
  auto& number = *form.widget.findChild<QDoubleSpinBox*>("reach");
  form.field->choose(fixedAt(15)); // as by settings that are read before a plant is open
  EXPECT_EQ(label.text(), "Reach: 1.00 to 10.00");
  EXPECT_EQ(number.value(), 15) << "what a reconstruction would refuse";
  form.field->setScale({.spacing = 2, .height = 100}, "mm");
  EXPECT_EQ(label.text(), "Reach") << "right for this plant";
  EXPECT_EQ(form.field->chosen(), fixedAt(15));
  EXPECT_EQ(number.maximum(), 20);
  form.field->choose(fixedAt(0.5));
  EXPECT_EQ(label.text().simplified(), QString("Reach: 2.00 to 20.00 mm"));
  EXPECT_EQ(number.value(), 0.5);
  number.setValue(3);
  EXPECT_EQ(label.text(), "Reach");
  EXPECT_EQ(number.minimum(), 2);
}

// A field rounds the ends of its range, too: 60 spacings of 0.00491303 would be 0.2948.
TEST(OptionField, OfACountShowsOneThatIsNotWholeAsItIs) {
  Form form({.name = "neighbors",
             .label = "Neighbors",
             .kind = OptionKind::count,
             .rule = fixedAt(12),
             .minimum = 3,
             .maximum = 60,
             .help = "How many."});
  form.field->setScale({.spacing = 1, .height = 100}, "mm");
  const auto& label = *form.widget.findChild<QLabel*>();
  auto& number = *form.widget.findChild<QDoubleSpinBox*>("neighbors");
  EXPECT_EQ(number.text(), "12");
  form.field->choose(fixedAt(3.5));
  EXPECT_EQ(number.value(), 3.5);
  EXPECT_EQ(label.text(), "Neighbors: a whole number, 3 to 60");
  number.setValue(4);
  EXPECT_EQ(number.text(), "4");
  EXPECT_EQ(label.text(), "Neighbors");
}

TEST(OptionField, OfANumberTakesNoValueThatIsRoundedOutOfItsRange) {
  Form form({.name = "reach",
             .label = "Reach",
             .kind = OptionKind::length,
             .rule = spacings(4),
             .minimum = 1,
             .maximum = 60,
             .help = "How far."});
  const PlantScale scale{.spacing = 0.00491303, .height = 2};
  form.field->setScale(scale, "m");
  auto& number = *form.widget.findChild<QDoubleSpinBox*>("reach");
  const auto chosen = [&] { return form.field->chosen()->value(scale); };
  for (const double beyond : {1.0, 0.294782}) {
    number.setValue(0.1);
    number.setValue(beyond);
    EXPECT_LE(chosen(), 60 * scale.spacing);
    EXPECT_NEAR(chosen(), 60 * scale.spacing, 1e-4);
  }
  number.setValue(0);
  EXPECT_GE(chosen(), scale.spacing);
  EXPECT_NEAR(chosen(), scale.spacing, 1e-4);
}

} // namespace
} // namespace espalier
