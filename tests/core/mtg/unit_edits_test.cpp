#include "core/base/error.h"
#include "core/mtg/feature_edits.h"
#include "core/mtg/mtg_edits.h"
#include "core/mtg/typed_values.h"
#include "core/mtg/unit_edits.h"
#include "core/mtg/unit_scales.h"
#include "tests/core/mtg/mtg_text.h"

#include <gtest/gtest.h>

#include <functional>

namespace espalier {
namespace {

// P1 of A1 (E1 < E2 < E3 < E4); A1 has values, as E2 has its radius.
Mtg oneAxis() {
  return test::readMtgRows("/P1\n^/A1\t\t\t9\t9\t9\n^/E1\t\t\t0\t0\t0\n^<E2\t\t\t0\t0\t1\t0.50\n"
                           "^<E3\t\t\t0\t0\t2\n^<E4\t\t\t0\t0\t3\n")
      .value;
}

struct Case {
  Mtg base = oneAxis();
  Skeleton plant = skeletonOf(base, "plant.mtg").value;

  Mtg after(const std::function<void(SkeletonEditor&)>& change) {
    SkeletonEditor editor(plant);
    change(editor);
    (void)editor.commit();
    return withEdits(base, plant);
  }
};

std::string why(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(TypedValue, IsTakenAsItIsTyped) {
  EXPECT_EQ(typedValue({"a", "REAL"}, " -1.50 "), "-1.50");
  EXPECT_EQ(typedValue({"a", "REAL"}, "2e3"), "2e3");
  EXPECT_EQ(typedValue({"a", "INT"}, "-12"), "-12");
  EXPECT_EQ(typedValue({"a", "ALPHA"}, "2 * 3"), "2 * 3"); // never evaluated
  EXPECT_EQ(typedValue({"a", "STRING"}, "Ast-größe"), "Ast-größe");
  EXPECT_EQ(typedValue({"a", "DD/MM/YY"}, "29/02/96"), "29/02/96");
  EXPECT_EQ(typedValue({"a", "DD/MM"}, "31/12"), "31/12");
  EXPECT_EQ(typedValue({"a", "MM/YY"}, "12/98"), "12/98");
  EXPECT_EQ(typedValue({"a", "DD/MM/YYYY"}, "01/10/2003"), "01/10/2003");
  EXPECT_EQ(typedValue({"a", "DD/MM-TIME"}, "01/10-23:59"), "01/10-23:59");
  EXPECT_EQ(typedValue({"a", "DD/MM/YY-TIME"}, "01/10/03-00:00"), "01/10/03-00:00");
  EXPECT_EQ(typedValue({"a", "REAL"}, "  "), "");
}

TEST(TypedValue, OfAnotherTypeIsRefused) {
  const std::vector<std::pair<const char*, const char*>> wrong = {
      {"REAL", "two"},          {"REAL", "1,5"},
      {"REAL", "2*3"},          {"REAL", "inf"},
      {"REAL", "nan"},          {"REAL", "NA"},
      {"INT", "1.5"},           {"INT", "-"},
      {"INT", "0x10"},          {"INT", "12345678901234567890"},
      {"DD/MM/YY", "1/2/03"},   {"DD/MM/YY", "31/04/03"},
      {"DD/MM/YY", "03-04-05"}, {"DD/MM", "00/12"},
      {"MM/YY", "13/98"},       {"DD/MM/YYYY", "01/10/03"},
      {"DD/MM-TIME", "01/10"},  {"DD/MM-TIME", "01/10-24:00"},
      {"ALPHA", "a\tb"},        {"ALPHA", "a\nb"},
      {"STRING", "a # b"}};
  for (const auto& [type, text] : wrong)
    EXPECT_THROW((void)typedValue({"a", type}, text), Error) << type << ' ' << text;
}

TEST(TypedValue, IsRefusedWithTheTypeAndAnExample) {
  EXPECT_EQ(why([] {
              (void)typedValue({"Length", "REAL"}, "long");
            }),
            "Length is of type REAL: 'long' is not a number, such as 12.5");
}

TEST(UnitsOf, AreThoseThatStartAtTheNodeAndBelowIt) {
  Case one;
  const std::vector<UnitPlace> units = unitsOf(one.plant, NodeId{3});
  ASSERT_EQ(units.size(), 2U);
  EXPECT_EQ(one.plant[units[0].start].entities[units[0].entity].symbol, "P");
  EXPECT_EQ(one.plant[units[1].start].entities[units[1].entity].symbol, "A");
}

TEST(BeginUnit, GivesTheNodesAboveToANewUnitWithTheNextIndex) {
  Case one;
  const Mtg mtg = one.after([](SkeletonEditor& e) { beginUnit(e, NodeId{2}, 2); });
  ASSERT_EQ(mtg.vertices.size(), one.base.vertices.size() + 1);
  const MtgVertex& e3 = mtg.vertices[mtg.vertices.size() - 2];
  const MtgVertex& axis = mtg.vertices[indexOf(*e3.complex)];
  EXPECT_EQ(axis.symbol, "A");
  EXPECT_EQ(axis.index, 2);
  EXPECT_EQ(axis.parent, VertexId{1});
  EXPECT_EQ(mtg.vertices.back().complex, e3.complex);
}

TEST(EndUnit, JoinsThemAgain) {
  Case one;
  const Mtg mtg = one.after([](SkeletonEditor& e) {
    beginUnit(e, NodeId{2}, 2);
    endUnit(e, NodeId{2}, 2);
  });
  EXPECT_EQ(mtg, one.base);
}

TEST(BeginUnit, CutsTheFinerUnitsThatGoOn) {
  Case one;
  const Mtg mtg = one.after([](SkeletonEditor& e) { beginUnit(e, NodeId{2}, 1); });
  EXPECT_EQ(mtg.vertices.size(), one.base.vertices.size() + 2); // a plant, and an axis of it
}

TEST(BeginUnit, IsRefusedWhereOneBegins) {
  Case one;
  EXPECT_THROW(one.after([](SkeletonEditor& e) { beginUnit(e, NodeId{0}, 2); }), Error);
}

TEST(EndUnit, IsRefusedAtRootsWhereNoneBeginsAndBelowACoarserOne) {
  Case one;
  EXPECT_THROW(one.after([](SkeletonEditor& e) { endUnit(e, NodeId{0}, 1); }), Error);
  EXPECT_THROW(one.after([](SkeletonEditor& e) { endUnit(e, NodeId{1}, 2); }), Error);
  EXPECT_THROW(one.after([](SkeletonEditor& e) { endUnit(e, NodeId{1}, 3); }), Error); // a node
  EXPECT_THROW(one.after([](SkeletonEditor& e) {
    beginUnit(e, NodeId{2}, 1);
    endUnit(e, NodeId{2}, 2);
  }),
               Error);
  EXPECT_EQ(one.plant, skeletonOf(one.base, "plant.mtg").value);
}

TEST(SetClass, WritesTheNewClassOfOneVertex) {
  Case one;
  Mtg expected = one.base;
  expected.vertices[1].symbol = "Branch";
  expected.classes.push_back({.symbol = "Branch", .scale = 2});
  for (const char* edge : {"<", "+"}) // the file has rules, so the new class has its own
    expected.rules.push_back({"Branch", "Branch", edge, "?"});
  EXPECT_EQ(one.after([&](SkeletonEditor& e) { setClass(e, NodeId{0}, 2, "Branch", &one.base); }),
            expected);
  EXPECT_EQ(one.after([&](SkeletonEditor& e) { setClass(e, NodeId{0}, 2, "A", &one.base); }),
            one.base); // back to one that no vertex is of now
}

TEST(SetClass, IsRefusedForAClassOfAnotherScaleAndForNoSymbol) {
  Case one;
  const auto set = [&](const char* symbol) {
    return why([&] {
      one.after([&](SkeletonEditor& e) { setClass(e, NodeId{0}, 2, symbol, &one.base); });
    });
  };
  EXPECT_EQ(set("E"), "the class E is of scale 3, this is of scale 2: choose another symbol");
  EXPECT_NE(set("B2"), "");
  EXPECT_NE(set(""), "");
}

TEST(SetClass, KnowsScalesThatMoved) {
  Case one;
  one.after([&](SkeletonEditor& e) {
    toggleMarks(e, {NodeId{2}});
    commitMarks(e, {"S", {}}, &one.base);
    setClass(e, NodeId{0}, 2, "B", &one.base);
  });
  one.after([&](SkeletonEditor& e) { setClass(e, NodeId{0}, 2, "A", &one.base); });
  EXPECT_THROW(one.after([&](SkeletonEditor& e) { setClass(e, NodeId{0}, 3, "E", &one.base); }),
               Error);
}

TEST(SetIndex, WritesAndClearsIt) {
  Case one;
  Mtg expected = one.base;
  expected.vertices[3].index = 7; // E2
  EXPECT_EQ(one.after([](SkeletonEditor& e) { setIndex(e, NodeId{1}, 3, " 7 "); }), expected);
  expected.vertices[3].index.reset();
  EXPECT_EQ(one.after([](SkeletonEditor& e) { setIndex(e, NodeId{1}, 3, ""); }), expected);
}

TEST(SetIndex, MayHaveADot) {
  Case one;
  Mtg expected = one.base;
  expected.vertices[3].index = LabelIndex::in("16.01");
  EXPECT_EQ(one.after([](SkeletonEditor& e) { setIndex(e, NodeId{1}, 3, "16.01"); }), expected);
}

TEST(SetIndex, IsRefusedForWhatIsNoIndex) {
  Case one;
  for (const char* text : {"-1", "2.", ".5", "x", "99999999999"})
    EXPECT_THROW(one.after([&](SkeletonEditor& e) { setIndex(e, NodeId{1}, 3, text); }), Error)
        << text;
}

TEST(SetFeature, WritesTheTextOfOneValue) {
  Case one;
  Mtg expected = one.base;
  expected.vertices[1].values[1] = "8.50"; // YY of A1
  const MtgFeature yy{"YY", "REAL"};
  EXPECT_EQ(one.after([&](SkeletonEditor& e) {
    setFeature(e, NodeId{0}, 2, {yy, "8.50"}, &one.base);
  }),
            expected);
  expected.vertices[1].values[1].clear();
  EXPECT_EQ(one.after([&](SkeletonEditor& e) {
    setFeature(e, NodeId{0}, 2, {yy, ""}, &one.base);
  }),
            expected);
  EXPECT_EQ(one.after([&](SkeletonEditor& e) {
    setFeature(e, NodeId{0}, 2, {yy, "9"}, &one.base);
  }),
            one.base);
  EXPECT_THROW(one.after([&](SkeletonEditor& e) {
    setFeature(e, NodeId{0}, 2, {yy, "x"}, &one.base);
  }),
               Error);
}

// The unit A1 is E1 and E3, with E2 of A2 between them: E3 carries its name alone.
TEST(SetIndex, OfAUnitInSeveralPartsKeepsItsValues) {
  Case one;
  one.base.vertices = {{.symbol = "P", .index = 1, .scale = 1},
                       {.symbol = "A", .index = 1, .scale = 2, .values = {"9", "8"}},
                       {.symbol = "A", .index = 2, .scale = 2, .parent = VertexId{1}}};
  one.base.vertices[1].complex = one.base.vertices[2].complex = VertexId{0};
  for (int i = 0; i < 3; ++i) {
    MtgVertex node{
        .symbol = "E", .index = i + 1, .scale = 3, .complex = VertexId{i == 1 ? 2U : 1U}};
    if (i > 0) node.parent = VertexId{2U + static_cast<unsigned>(i)};
    node.values = {"0", "0", std::to_string(i)};
    one.base.vertices.push_back(node);
  }
  one.plant = skeletonOf(one.base, "plant.mtg").value;
  Mtg expected = one.base;
  expected.vertices[1].index = 5;
  EXPECT_EQ(one.after([](SkeletonEditor& e) { setIndex(e, NodeId{2}, 2, "5"); }), expected);
  expected.vertices[1].values[1] = "7";
  EXPECT_EQ(one.after([&](SkeletonEditor& e) {
    setFeature(e, NodeId{2}, 2, {{"YY", "REAL"}, "7"}, &one.base);
  }),
            expected);
}

TEST(TypedFeatures, OfNodesAreWithoutPositionAndRadius) {
  Case one;
  one.base.features.push_back({"Length", "REAL"});
  const auto names = [&](bool isNode) {
    std::string all;
    for (const MtgFeature& feature : typedFeatures({.values = {{"Note", "x"}}}, isNode, &one.base))
      all += feature.name + ":" + feature.type + " ";
    return all;
  };
  EXPECT_EQ(names(true), "Length:REAL Note:ALPHA ");
  EXPECT_EQ(names(false), "Length:REAL Note:ALPHA ");
  const std::vector<MtgFeature> ofUnit =
      typedFeatures({.values = {{"YY", "1"}}}, false, &one.base); // as a file says
  EXPECT_EQ(ofUnit, (std::vector<MtgFeature>{{"YY", "REAL"}, {"Length", "REAL"}}));
}

} // namespace
} // namespace espalier
