#include "core/pipeline/check_table.h"
#include "ui/panels/check_form.h"

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(CheckForm, HasAFieldForEachLimitOfTheTable) {
  const CheckForm form;
  for (const Option& option : checkTable().descriptions())
    EXPECT_NE(form.findChild<QWidget*>(QString::fromStdString(option.name)), nullptr)
        << option.name;
  EXPECT_EQ(form.options().clusterSize, CheckOptions().clusterSize);
  EXPECT_NEAR(form.options().sharpTurn, CheckOptions().sharpTurn, 1e-9);
  EXPECT_TRUE(form.chosen().empty());
}

TEST(CheckForm, GivesWhatIsTyped) {
  CheckForm form;
  const QSignalSpy changed(&form, &CheckForm::changed);
  auto* turn = form.findChild<QDoubleSpinBox*>("sharp_turn");
  ASSERT_NE(turn, nullptr);
  turn->setValue(45);
  EXPECT_EQ(changed.count(), 1);
  EXPECT_NEAR(form.options().sharpTurn, std::numbers::pi / 4, 1e-9);
  EXPECT_THAT(form.chosen(), ElementsAre(Pair("sharp_turn", 45)));
  EXPECT_EQ(form.findChild<QToolButton*>("check_form_header")->text(),
            "Limits of the checks (1 set)");
}

TEST(CheckForm, ShowsWhatAProjectKept) {
  CheckForm form;
  const QSignalSpy changed(&form, &CheckForm::changed);
  form.choose({{"cluster_size", 7}, {"sharp_turn", 1e9}, {"of_a_later_version", 3}});
  EXPECT_THAT(form.chosen(), ElementsAre(Pair("cluster_size", 7), Pair("sharp_turn", 180)));
  EXPECT_EQ(form.options().clusterSize, 7);
  form.choose({});
  EXPECT_TRUE(form.chosen().empty());
  EXPECT_EQ(form.findChild<QToolButton*>("check_form_header")->text(), "Limits of the checks");
  EXPECT_EQ(changed.count(), 0) << "it was not the user";
}

TEST(CheckForm, OpensAndFolds) {
  CheckForm form;
  form.show();
  auto* header = form.findChild<QToolButton*>("check_form_header");
  auto* turn = form.findChild<QDoubleSpinBox*>("sharp_turn");
  EXPECT_FALSE(turn->isVisible());
  QTest::mouseClick(header, Qt::LeftButton);
  EXPECT_TRUE(form.isOpen());
  EXPECT_TRUE(turn->isVisible());
  QTest::mouseClick(header, Qt::LeftButton);
  EXPECT_FALSE(turn->isVisible());
}

} // namespace
} // namespace espalier
