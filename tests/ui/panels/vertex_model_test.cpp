#include "core/mtg/mtg_reader.h"
#include "ui/panels/vertex_model.h"

#include <QAbstractItemModelTester>
#include <gtest/gtest.h>

#include <sstream>

namespace espalier {
namespace {

std::shared_ptr<const MtgFrame> frameOf(const std::string& rows) {
  std::istringstream in("CODE :\tFORM-A\nCLASSES :\nSYMBOL\tSCALE\nP\t1\nA\t2\nU\t3\nFEATURES :\n"
                        "NAME\tTYPE\nAlias\tALPHA\nLength\tREAL\nMTG :\nENTITY-CODE\t\t\tAlias\t"
                        "Length\n" +
                        rows);
  return std::make_shared<const MtgFrame>(MtgFrame{readMtg(in, "plant.mtg").value, ""});
}

QString text(const VertexModel& model, const QModelIndex& row, int column) {
  return model.data(row.siblingAtColumn(column), Qt::DisplayRole).toString();
}

TEST(VertexModel, HasThePartsOfAVertexBelowIt) {
  VertexModel model;
  const QAbstractItemModelTester tester(&model,
                                        QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.show(frameOf("/P1/A1\n\t/U1\t\tfoot\t4\n\t^<U16.1\t\t\t3\n\t\t+A2/U1\n/P2\n"));
  ASSERT_EQ(model.rowCount(), 2);
  const QModelIndex plant = model.index(0, 0);
  ASSERT_EQ(model.rowCount(plant), 2) << "two axes";
  const QModelIndex axis = model.index(0, 0, plant);
  EXPECT_EQ(text(model, model.index(1, 0, plant), 2), "+ A1");
  ASSERT_EQ(model.rowCount(axis), 2);
  const QModelIndex first = model.index(0, 0, axis);
  EXPECT_EQ(text(model, first, 0), "U1");
  EXPECT_EQ(text(model, first, 3), "foot");
  EXPECT_EQ(text(model, first, 4), "4");
  EXPECT_EQ(text(model, model.index(1, 0, axis), 0), "U16.1");
  EXPECT_EQ(text(model, model.index(1, 0, axis), 2), "< U1");
}

TEST(VertexModel, HasLaterDatesBelowTheirVertex) {
  VertexModel model;
  const QAbstractItemModelTester tester(&model,
                                        QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.show(frameOf("/P1\t\t\t\t4\n*\t\t\t\t5\n*\t\t\t\t6\n\t/A1\n\t\t/U1\n"));
  const QModelIndex plant = model.index(0, 0);
  ASSERT_EQ(model.rowCount(plant), 3) << "two dates, one axis";
  EXPECT_EQ(text(model, model.index(1, 0, plant), 0), "at later date 2");
  EXPECT_EQ(text(model, model.index(1, 0, plant), 4), "6");
  EXPECT_EQ(text(model, model.index(2, 0, plant), 0), "A1");
  EXPECT_EQ(model.rowCount(model.index(1, 0, plant)), 0);
}

TEST(VertexModel, IsEmptyWithoutAPlant) {
  VertexModel model;
  const QAbstractItemModelTester tester(&model,
                                        QAbstractItemModelTester::FailureReportingMode::Fatal);
  EXPECT_EQ(model.rowCount(), 0);
  model.show(frameOf("/P1\n"));
  model.show(nullptr);
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(model.columnCount(), 0);
}

} // namespace
} // namespace espalier
