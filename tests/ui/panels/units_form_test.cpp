#include "core/base/error.h"
#include "core/mtg/feature_edits.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/unit_scales.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/plants.h"
#include "ui/document/plant_document.h"
#include "ui/panels/units_form.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

namespace espalier {
namespace {

// P1 of A1 (E1 < E2 < E3).
struct UnitsFormTest : testing::Test {
  PlantDocument document;
  UnitsForm form{document};
  std::string refusal;
  QWidget* refusedAt = nullptr;

  void SetUp() override {
    Mtg mtg = test::readMtgRows("/P1\n^/A1\t\t\t9\t9\t9\n^/E1\t\t\t0\t0\t0\n"
                                "^<E2\t\t\t0\t0\t1\n^<E3\t\t\t0\t0\t2\n")
                  .value;
    Skeleton skeleton = skeletonOf(mtg, "plant.mtg").value;
    document.openStructure(
        {std::move(skeleton), std::make_shared<const MtgFrame>(MtgFrame{std::move(mtg), ""})},
        "plant.mtg");
    QObject::connect(&form, &UnitsForm::typed,
                     [this](const QString& name, const auto& change, QWidget* field) {
                       try {
                         document.edit(name, change);
                       } catch (const Error& error) {
                         refusal = error.what();
                         refusedAt = field;
                       }
                     });
    QObject::connect(&document, &PlantDocument::skeletonEdited, &form,
                     [this] { form.show(NodeId{2}); });
    form.show(NodeId{2});
  }
  QLineEdit& field(const QString& id) {
    auto* found = form.findChild<QLineEdit*>(id);
    EXPECT_NE(found, nullptr) << id.toStdString();
    return *found;
  }
  void type(const QString& id, const QString& text) {
    QLineEdit& to = field(id);
    to.selectAll();
    QTest::keyClicks(&to, text);
    QTest::keyClick(&to, Qt::Key_Return);
  }
};

TEST_F(UnitsFormTest, ShowsTheNodeAndTheUnitsItBelongsTo) {
  EXPECT_EQ(field("class_3").text(), "E");
  EXPECT_EQ(field("index_3").text(), "3");
  EXPECT_EQ(field("class_2").text(), "A");
  EXPECT_EQ(field("feature_XX_2").text(), "9");
  EXPECT_EQ(field("class_1").text(), "P");
  EXPECT_EQ(form.findChild<QLineEdit*>("feature_XX_3"), nullptr) << "its position is no value";
}

TEST_F(UnitsFormTest, TakesWhatIsTypedOnEnterAsOneStep) {
  QSignalSpy left(&form, &UnitsForm::leaveRequested);
  type("index_2", "5");
  EXPECT_EQ(document.skeleton()[NodeId{0}].entities[1].index, 5);
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(document.undoStack().undoText(), "Set the index of A1");
  EXPECT_EQ(left.count(), 1);
  document.undoStack().undo();
  EXPECT_EQ(field("index_2").text(), "1");
}

TEST_F(UnitsFormTest, KeepsAWrongTextForCorrection) {
  QSignalSpy left(&form, &UnitsForm::leaveRequested);
  type("feature_XX_2", "2*3");
  EXPECT_EQ(refusal, "XX is of type REAL: '2*3' is not a number, such as 12.5");
  EXPECT_EQ(refusedAt, &field("feature_XX_2"));
  EXPECT_EQ(field("feature_XX_2").text(), "2*3");
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_EQ(left.count(), 0);
  type("feature_XX_2", "6");
  EXPECT_EQ(document.skeleton()[NodeId{0}].entities[1].values[0].text, "6");
}

TEST_F(UnitsFormTest, BeginsAndEndsUnitsAtTheNode) {
  auto* begins = form.findChild<QCheckBox*>("begins_unit_2");
  ASSERT_NE(begins, nullptr);
  EXPECT_FALSE(begins->isChecked());
  begins->click();
  EXPECT_EQ(document.undoStack().undoText(), "Begin a unit like A1 at node 2");
  EXPECT_EQ(field("index_2").text(), "2");
  begins = form.findChild<QCheckBox*>("begins_unit_2");
  EXPECT_TRUE(begins->isChecked());
  begins->click();
  EXPECT_EQ(document.undoStack().undoText(), "End A2 at node 2");
  EXPECT_EQ(field("index_2").text(), "1");
}

TEST_F(UnitsFormTest, ShowsAndTakesAnAlias) {
  EXPECT_EQ(field("alias_2").text(), "");
  type("alias_2", "Trunk");
  EXPECT_EQ(document.skeleton()[NodeId{0}].entities[1].alias, "Trunk");
  EXPECT_EQ(document.undoStack().undoText(), "Set the alias of A1");
  type("alias_3", "Trunk");
  EXPECT_EQ(refusal, "'Trunk' is the alias of A1 at node 0 already: choose another one");
  EXPECT_EQ(refusedAt, &field("alias_3"));
}

TEST_F(UnitsFormTest, ShowsAndTakesValuesAtLaterDates) {
  document.edit("Add a date", [](SkeletonEditor& editor) {
    std::vector<Entity> entities = editor.skeleton()[NodeId{0}].entities;
    entities[1].later = {{{"Date", "01/05/98", "DD/MM/YY"}, {"XX", "5"}}};
    editor.setEntities(NodeId{0}, entities);
  });
  EXPECT_EQ(form.findChild<QLabel*>("heading_feature_XX_2_later0")->text(), "At 01/05/98");
  EXPECT_EQ(field("feature_XX_2_later0").text(), "5");
  EXPECT_EQ(field("feature_XX_2").text(), "9") << "the first date stays beside it";
  type("feature_XX_2_later0", "long");
  EXPECT_EQ(refusedAt, &field("feature_XX_2_later0"));
  type("feature_XX_2_later0", "6");
  EXPECT_EQ(document.skeleton()[NodeId{0}].entities[1].later[0][1].text, "6");
  EXPECT_EQ(document.undoStack().undoText(), "Set XX of A1");
}

TEST_F(UnitsFormTest, OffersAFeatureAddedByHandToAllNodesAndUnits) {
  document.edit("Add", [](SkeletonEditor& editor) {
    addFeature(editor, NodeId{0}, 3, {{"Leaves", "INT"}, "3"}, nullptr);
  });
  EXPECT_EQ(field("feature_Leaves_1").text(), "");
  type("feature_Leaves_3", "two");
  EXPECT_EQ(refusal, "Leaves is of type INT: 'two' is not a whole number, such as 12");
  type("feature_Leaves_3", "2");
  EXPECT_EQ(document.skeleton()[NodeId{2}].entities.back().values.back(),
            (FeatureValue{"Leaves", "2", "INT"}));
}

TEST_F(UnitsFormTest, AsksForWhatIsAdded) {
  QSignalSpy feature(&form, &UnitsForm::featureRequested);
  form.findChild<QPushButton*>("add_feature_unit_2")->click();
  EXPECT_EQ(feature.count(), 1);
  EXPECT_EQ(form.findChild<QPushButton*>("add_date_unit_2"), nullptr)
      << "no feature can be typed at a later date: positions are the node's";
}

TEST_F(UnitsFormTest, OffersAFeatureWhereNothingIsCarriedYet) {
  document.openSkeleton(test::stick(2), "stick.swc");
  form.show(NodeId{0});
  EXPECT_EQ(form.findChild<QLabel*>("title_unit_2")->text(), "No features yet");
  EXPECT_EQ(form.findChild<QLineEdit*>("class_2"), nullptr);
  QSignalSpy asked(&form, &UnitsForm::featureRequested);
  form.findChild<QPushButton*>("add_feature_unit_2")->click();
  EXPECT_EQ(asked.count(), 1);
}

} // namespace
} // namespace espalier
