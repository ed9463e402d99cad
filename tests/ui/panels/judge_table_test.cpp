#include "ui/panels/judge_table.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QTest>
#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr int differenceRole = Qt::UserRole;

/// The plant, and a state with fewer lost tips and thicker wood.
class ShownTable : public testing::Test {
protected:
  ShownTable() {
    table_.show({"Plant", "A"},
                {{"Lost tips", {}, "Ends without points.", Better::less, 0, {12.0, 9.0}},
                 {"Thickness", "mm", "Spread of the points.", Better::less, 2, {1.5, 1.75}},
                 {"Length", "m", "Of all edges.", Better::neither, 1, {14.0, 15.0}},
                 {"Score", {}, "Of the reference.", Better::more, 3, {std::nullopt, 0.5}}});
  }
  QString difference(int row) const { return table_.item(row, 2)->data(differenceRole).toString(); }

  JudgeTable table_;
};

TEST_F(ShownTable, ShowsTheDifferenceToTheFirstStateAndWhetherItIsBetter) {
  EXPECT_EQ(difference(0), "−3 ✓") << "less is better";
  EXPECT_EQ(difference(1), "+0.25 ✗") << "more is worse";
  EXPECT_EQ(difference(2), "+1.0") << "nobody knows";
  EXPECT_EQ(difference(3), "") << "there is nothing to compare it with";
  EXPECT_EQ(table_.item(3, 1)->text(), "–");
}

TEST_F(ShownTable, CallsEqualWhatIsWrittenAlike) {
  table_.show({"Plant", "A"}, {{"F", {}, {}, Better::more, 2, {0.5, 0.501}}});
  EXPECT_EQ(difference(0), "=");
}

TEST_F(ShownTable, ComparesNothingThatIsOfOtherPoints) {
  table_.show({"Plant", "Ball"}, {{"Lost tips", {}, {}, Better::less, 0, {12, 3}}}, false);
  EXPECT_EQ(difference(0), "");
}

TEST_F(ShownTable, ShowsTheDifferenceOfWhatIsWritten) {
  table_.show({"Plant", "A"}, {{"Length", "m", {}, Better::less, 0, {32.4, 30.6}}});
  EXPECT_EQ(difference(0), "−1 ✓") << "from 32 to 31";
}

TEST_F(ShownTable, SaysWhatANumberIs) {
  EXPECT_EQ(table_.item(1, 0)->text(), "Thickness [mm]");
  EXPECT_TRUE(table_.item(1, 2)->toolTip().contains("Spread of the points. Less is better."));
}

TEST_F(ShownTable, IsCopiedForASpreadsheet) {
  QTest::keyClick(&table_, Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), "Number\tUnit\tPlant\tA\n"
                                                  "Lost tips\t\t12\t9\n"
                                                  "Thickness\tmm\t1.5\t1.75\n"
                                                  "Length\tm\t14\t15\n"
                                                  "Score\t\t\t0.5\n");
}

TEST_F(ShownTable, PaintsTheDifferenceBesideTheNumber) {
  table_.resize(500, 160);
  table_.QWidget::show();
  const QImage with = table_.grab().toImage();
  table_.item(0, 2)->setData(differenceRole, QString());
  EXPECT_NE(table_.grab().toImage(), with);
}

} // namespace
} // namespace espalier
