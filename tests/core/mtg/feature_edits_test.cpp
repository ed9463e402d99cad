#include "core/base/error.h"
#include "core/mtg/feature_edits.h"
#include "core/mtg/mtg_edits.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_text_edit.h"
#include "core/mtg/typed_values.h"
#include "core/mtg/unit_edits.h"
#include "core/project/node_bytes.h"
#include "tests/core/mtg/mtg_text.h"

#include <gtest/gtest.h>

#include <functional>

namespace espalier {
namespace {

const std::string rows = "/P1\n^/A1\n^/E1\t\t\t0\t0\t0\n^<E2\t\t\t0\t0\t1\n";

// P1 of A1 (E1 < E2), as nodes 0 and 1.
struct FeatureEdits : testing::Test {
  Mtg base = test::readMtgRows(rows).value;
  Skeleton plant = skeletonOf(base, "plant.mtg").value;
  SkeletonDelta delta;

  void edit(const std::function<void(SkeletonEditor&)>& change) {
    SkeletonEditor editor(plant);
    change(editor);
    delta = editor.commit();
  }
  void add(const std::string& name, const std::string& type, const std::string& text,
           NodeId id = NodeId{0}, int scale = 3) {
    edit([&](SkeletonEditor& e) { addFeature(e, id, scale, {{name, type}, text}, &base); });
  }
  /// Why adding is refused; the plant must stay as it is.
  std::string refusal(const std::string& name, const std::string& type, const std::string& text) {
    const Skeleton before = plant;
    try {
      add(name, type, text);
    } catch (const Error& error) {
      EXPECT_EQ(plant, before);
      return error.what();
    }
    return "";
  }
  [[nodiscard]] Mtg saved() const {
    std::istringstream in(mtgTextWith(test::mtgText(rows), withEdits(base, plant)));
    return readMtg(in, "saved.mtg").value;
  }
};

TEST_F(FeatureEdits, ANewFeatureIsDeclaredInTheFileThatIsSaved) {
  add("Length", "REAL", "12.5");
  add("Leaves", "INT", "3", NodeId{0}, 2);
  const Mtg mtg = saved();
  const std::vector<MtgFeature> expected = {{"Leaves", "INT"}, {"Length", "REAL"}};
  ASSERT_EQ(mtg.features.size(), base.features.size() + 2);
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), mtg.features.end() - 2));
  EXPECT_EQ(entityOf(mtg, VertexId{1}).values, (std::vector<FeatureValue>{{"Leaves", "3"}}));
  EXPECT_EQ(entityOf(mtg, VertexId{2}).values.back(), (FeatureValue{"Length", "12.5"}));
  ASSERT_EQ(mtg.vertices.size(), base.vertices.size());
  for (std::size_t i = 0; i < mtg.vertices.size(); ++i)
    EXPECT_EQ(mtg.vertices[i].complex, base.vertices[i].complex);
}

TEST_F(FeatureEdits, ANewFeatureCanBeTypedForAllEntitiesAndIsCheckedByItsType) {
  add("Leaves", "INT", "3");
  const std::vector<MtgFeature> added = addedFeatures(plant, &base);
  EXPECT_EQ(added, (std::vector<MtgFeature>{{"Leaves", "INT"}}));
  EXPECT_EQ(typedFeatures(ownEntity(plant, NodeId{1}), true, &base, added).back(), added.front());
  EXPECT_EQ(typedFeatures(plant[NodeId{0}].entities[0], false, &base, added).back(), added.front());
  edit([&](SkeletonEditor& e) { setFeature(e, NodeId{1}, 3, {added.front(), "4"}, &base); });
  EXPECT_THROW(edit([&](SkeletonEditor& e) {
                 setFeature(e, NodeId{1}, 3, {added.front(), "4.5"}, &base);
               }),
               Error);
  EXPECT_EQ(entityOf(saved(), VertexId{3}).values.back(), (FeatureValue{"Leaves", "4"}));
}

TEST_F(FeatureEdits, AnUndoTakesTheFeatureBack) {
  add("Length", "REAL", "12.5");
  delta.inverse().apply(plant);
  EXPECT_TRUE(addedFeatures(plant, &base).empty());
  EXPECT_EQ(withEdits(base, plant), base);
}

TEST_F(FeatureEdits, GoesWithItsLastValue) {
  add("Length", "REAL", "12.5");
  edit([&](SkeletonEditor& e) { setFeature(e, NodeId{0}, 3, {{"Length", "REAL"}, ""}, &base); });
  EXPECT_EQ(withEdits(base, plant), base);
}

TEST_F(FeatureEdits, ATypeSurvivesAProject) {
  add("Leaves", "INT", "3");
  const auto back = plantFrom(bytesOf(plant));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->skeleton, plant);
  EXPECT_EQ(addedFeatures(back->skeleton, &base), (std::vector<MtgFeature>{{"Leaves", "INT"}}));
}

TEST_F(FeatureEdits, AreRefusedWithoutANameATypeOrAValueOfIt) {
  for (const char* name : {"", "two words", "1st", "a+b", "leaf-area", "größe"})
    EXPECT_NE(refusal(name, "REAL", "1").find("no name of a feature"), std::string::npos) << name;
  for (const char* name : {"XX", "y", "Radius", "diameter", "Alias"})
    EXPECT_NE(refusal(name, "REAL", "1").find("fields of their own"), std::string::npos) << name;
  EXPECT_EQ(refusal("Length", "REAL", "2*3"),
            "Length is of type REAL: '2*3' is not a number, such as 12.5");
  EXPECT_EQ(refusal("Length", "REAL", " "), "the feature Length has no value yet: type one");
  EXPECT_NE(refusal("Shape", "GEOMETRY", "leaf"), "");
}

TEST_F(FeatureEdits, AreRefusedForANameThatIsKnown) {
  base = test::readMtgRows("/P1\n^/A1\n^/E1\t\t\t0\t0\t0\n").value;
  base.features.push_back({"Length", "REAL"});
  plant = skeletonOf(base, "plant.mtg").value;
  EXPECT_NE(refusal("Length", "INT", "1"), "");
  add("Leaves", "INT", "3");
  EXPECT_EQ(refusal("Leaves", "REAL", "1"),
            "the plant has a feature Leaves already: type its value there, or choose another name");
}

TEST_F(FeatureEdits, EachTypeThatCanBeTypedTakesItsExample) {
  for (const std::string_view type : featureTypes())
    EXPECT_EQ(typedValue({"a", std::string(type)}, exampleOf(type)), exampleOf(type)) << type;
}

TEST_F(FeatureEdits, ALaterDateIsAddedFilledAndGoesWithItsLastValue) {
  const MtgFeature date{"Date", "DD/MM/YY"};
  const MtgFeature length{"Length", "REAL"};
  const auto set = [&](const TypedFeature& typed) {
    edit([&](SkeletonEditor& e) { setFeature(e, NodeId{1}, 3, typed, &base); });
  };
  set({date, "01/05/98", 0});
  set({length, "2.5", 0});
  set({date, "01/06/98", 1});
  const Entity then = entityOf(saved(), VertexId{3});
  EXPECT_EQ(then.later, (std::vector<std::vector<FeatureValue>>{
                            {{"Date", "01/05/98"}, {"Length", "2.5"}}, {{"Date", "01/06/98"}}}));
  EXPECT_THROW(set({length, "long", 1}), Error);
  EXPECT_EQ(plant[NodeId{1}].entities.back().later.size(), 2U);
  set({date, "", 1});
  set({date, "", 0});
  set({length, "", 0});
  EXPECT_EQ(withEdits(base, plant), base);
}

TEST_F(FeatureEdits, PositionsCanBeTypedAtALaterDateThatHasThem) {
  plant.setEntities(NodeId{1}, {{.scale = 3, .symbol = "E", .index = 2, .later = {{{"XX", "1"}}}}});
  const Entity& entity = plant[NodeId{1}].entities.back();
  EXPECT_EQ(typedFeaturesLater(entity, 0, &base), (std::vector<MtgFeature>{{"XX", "REAL"}}));
  EXPECT_TRUE(typedFeaturesLater(entity, 1, &base).empty());
}

// The unit A1 is E1 and E3, with E2 of A2 between them: E3 carries its name alone.
TEST_F(FeatureEdits, ADateTypedAtAFurtherPartComesAfterThoseOfTheUnit) {
  base.vertices = {{.symbol = "P", .index = 1, .scale = 1},
                   {.symbol = "A", .index = 1, .scale = 2, .values = {"1"}, .later = {{"2"}}},
                   {.symbol = "A", .index = 2, .scale = 2, .parent = VertexId{1}}};
  base.vertices[1].complex = base.vertices[2].complex = VertexId{0};
  for (unsigned i = 0; i < 3; ++i) {
    MtgVertex node{.symbol = "E", .scale = 3, .complex = VertexId{i == 1 ? 2U : 1U}};
    if (i > 0) node.parent = VertexId{2 + i};
    node.values = {"0", "0", std::to_string(i)};
    base.vertices.push_back(node);
  }
  plant = skeletonOf(base, "plant.mtg").value;
  ASSERT_TRUE(plant[NodeId{2}].entities.front().later.empty());
  edit([&](SkeletonEditor& e) { setFeature(e, NodeId{2}, 2, {{"XX", "REAL"}, "3", 0}, &base); });
  EXPECT_EQ(entityOf(withEdits(base, plant), VertexId{1}).later,
            (std::vector<std::vector<FeatureValue>>{{{"XX", "2"}}, {{"XX", "3"}}}));
}

TEST_F(FeatureEdits, AnAliasIsWrittenToItsColumn) {
  edit([](SkeletonEditor& e) { setAlias(e, NodeId{0}, 2, " Trunk_1 "); });
  const Mtg mtg = saved();
  EXPECT_EQ(mtg.features.front(), (MtgFeature{"Alias", "STRING"}));
  EXPECT_EQ(mtg.vertices[1].alias, "Trunk_1");
  edit([](SkeletonEditor& e) { setAlias(e, NodeId{0}, 2, ""); });
  EXPECT_EQ(withEdits(base, plant), base);
}

TEST_F(FeatureEdits, AnAliasIsRefusedIfItIsTakenOrCannotBeginACode) {
  edit([](SkeletonEditor& e) { setAlias(e, NodeId{0}, 2, "Trunk"); });
  const Skeleton before = plant;
  for (const char* alias : {"Trunk", "two words", "a(b", "-a", "a/b", "#"})
    EXPECT_THROW(edit([&](SkeletonEditor& e) { setAlias(e, NodeId{1}, 3, alias); }), Error)
        << alias;
  EXPECT_EQ(plant, before);
  edit([](SkeletonEditor& e) { setAlias(e, NodeId{0}, 2, "Trunk"); }); // its own
  EXPECT_TRUE(delta.isEmpty());
}

TEST(NodeFeatures, MakeUnitsOfAPlantThatHasNone) {
  Skeleton plant;
  const NodeId root = plant.add({.position = {0, 0, 0}});
  const NodeId tip = plant.add({.position = {0, 0, 1}, .parent = root});
  SkeletonEditor editor(plant);
  setNodeFeature(editor, tip, {{"Volume", "REAL"}, "2.5"}, nullptr);
  setNodeFeature(editor, root, {{"Volume", "REAL"}, "7"}, nullptr);
  setNodeFeature(editor, root, {{"Volume", "REAL"}, "8"}, nullptr);
  (void)editor.commit();
  EXPECT_EQ(nodesWithFeature(plant, "Volume"), (std::vector{root, tip}));
  EXPECT_EQ(nodesWithFeature(plant, "Weight"), std::vector<NodeId>());
  EXPECT_EQ(plant[root].entities.back().values,
            (std::vector<FeatureValue>{{"Volume", "8", "REAL"}}));
  setNodeFeature(editor, tip, {{"Volume", "REAL"}, ""}, nullptr);
  (void)editor.commit();
  EXPECT_EQ(nodesWithFeature(plant, "Volume"), std::vector{root});
}

} // namespace
} // namespace espalier
