// Whole MTGs through their text and back.
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_writer.h"
#include "core/mtg/openalea_limits.h"
#include "tests/core/mtg/mtg_text.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using test::readMtgRows;

Mtg mtgFrom(const std::string& text) {
  std::istringstream in(text);
  return readMtg(in, "plant.mtg").value;
}

/// The lines of the section MTG after that of the columns.
std::vector<std::string> rowsOf(const Mtg& mtg) {
  std::istringstream in(test::written(mtg));
  std::vector<std::string> rows;
  bool isRow = false;
  for (std::string line; std::getline(in, line);) {
    if (isRow) rows.push_back(line);
    isRow = isRow || line.starts_with("ENTITY-CODE") || line.starts_with("TOPO");
  }
  return rows;
}

/// Reading gives the same again but for the order of vertices, writing that the same bytes.
void expectRoundTrip(const Mtg& mtg) {
  const std::string text = test::written(mtg);
  const Mtg back = mtgFrom(text);
  EXPECT_EQ(back, mtgAsWritten(mtg)) << text;
  EXPECT_EQ(test::written(back), text);
}

std::string refusalOf(const Mtg& mtg) {
  std::ostringstream out;
  try {
    writeMtg(out, mtg);
  } catch (const Error& error) {
    EXPECT_EQ(out.str(), "");
    return error.what();
  }
  return "written without an error";
}

TEST(WriteWholeMtg, KeepsAllScales) {
  const Mtg mtg = readMtgRows("/P1/A1\n^/E1\n^<E2\n\t+A2/E1\n\t^<E2\n^<E3\n").value;
  EXPECT_EQ(mtgAsWritten(mtg), mtg) << "this order is that of its lines";
  EXPECT_THAT(rowsOf(mtg), testing::ElementsAre("/P1\t\t\t\t\t", "^/A1\t\t\t\t\t", "^/E1\t\t\t\t\t",
                                                "^<E2\t\t\t\t\t", "\t+A2\t\t\t\t", "\t^/E1\t\t\t\t",
                                                "\t^<E2\t\t\t\t", "^<E3\t\t\t\t\t"));
  expectRoundTrip(mtg);
}

TEST(WriteWholeMtg, KeepsUnitsThatFollowEachOtherWithoutTheirParts) {
  expectRoundTrip(readMtgRows("/P1\n^/A1\n\t/E1\n\t^<E2\n^<A2\n\t/E3\n").value);
}

TEST(WriteWholeMtg, KeepsUnitsWithTwoFirstParts) {
  expectRoundTrip(readMtgRows("/P1\n^/A1\n\t/E1\n\t/E2\n\t\t+E3\n^<A2/E4\n").value);
}

TEST(WriteWholeMtg, KeepsPlantsBesideEachOther) {
  expectRoundTrip(readMtgRows("/P1/A1/E1\n/P2\n/P3/A1\n").value);
}

// The third begins in no unit of scale 1: after P1 it would be read as a part of it.
TEST(WriteWholeMtg, WritesRootsOfFinerScalesFirst) {
  Mtg mtg = readMtgRows("/P1\n/P2/A1\n").value;
  mtg.vertices.back().complex = std::nullopt;
  EXPECT_THAT(rowsOf(mtg).front(), testing::StartsWith("/A1\t"));
  expectRoundTrip(mtg);
}

TEST(WriteWholeMtg, PutsTheSuccessorAfterWhatBranchesOff) {
  Mtg mtg = readMtgRows("/P1/A1/E1<E2\n").value;
  mtg.vertices.push_back({.symbol = "E",
                          .index = 9,
                          .scale = 3,
                          .complex = VertexId{1},
                          .parent = VertexId{2},
                          .edge = EdgeType::branching});
  EXPECT_THAT(rowsOf(mtg), testing::ElementsAre("/P1\t\t\t\t\t", "^/A1\t\t\t\t\t", "^/E1\t\t\t\t\t",
                                                "\t+E9\t\t\t\t", "^<E2\t\t\t\t\t"));
  expectRoundTrip(mtg);
}

// OpenAlea takes values apart at + and so fails on exponents.
TEST(WriteWholeMtg, WritesNumbersWithoutExponents) {
  Mtg mtg = readMtgRows("/P1\t\t\t1e+05\t+2.5E-3\t-5.4124e-005\t1e+05\n").value;
  EXPECT_EQ(rowsOf(mtg).front(), "/P1\t100000\t0.0025\t-0.000054124\t1e+05") << "radius is a text";
  expectRoundTrip(mtg);
  EXPECT_THAT(openAleaLimits(mtg), testing::ElementsAre(testing::HasSubstr("'1e+05' of radius")));
}

TEST(WriteWholeMtg, LeavesOtherNumbersAsTheyAre) {
  const Mtg mtg = readMtgRows("/P1\t\t\t1.500\t007\tNA\n").value;
  EXPECT_EQ(rowsOf(mtg).front(), "/P1\t1.500\t007\tNA\t");
}

TEST(WriteWholeMtg, RefusesWhatNoTextCanHold) {
  Mtg mtg = readMtgRows("/P1\t\t\t1\t2\t3\t4\n").value;
  const auto refusalOfValue = [&](const std::string& value) {
    mtg.vertices[0].values[3] = value;
    return refusalOf(mtg);
  };
  for (const char* value : {"a\tb", "a\nb", "a#b", " a", "a ", "a\rb"})
    EXPECT_THAT(refusalOfValue(value), testing::HasSubstr("cannot stand in an MTG text")) << value;
  EXPECT_EQ(refusalOfValue("a b, c"), "written without an error");
  mtg.vertices[0].symbol = "Q";
  EXPECT_THAT(refusalOf(mtg), testing::HasSubstr("Q1 is of scale 1, but no class"));
}

TEST(WriteWholeMtg, RefusesLabelsThatLookLikeOthers) {
  Mtg mtg{.classes = {{.symbol = "A", .scale = 1}, {.symbol = "A1", .scale = 2}}};
  mtg.vertices.push_back({.symbol = "A", .index = 12});
  EXPECT_THAT(refusalOf(mtg), testing::HasSubstr("A12 would be read from MTG text as another"));
}

TEST(WriteWholeMtg, WritesTheSectionsOfAnEmptyPlant) {
  const std::string text = test::written(Mtg{.classes = {{.symbol = "A", .scale = 1}}});
  EXPECT_THAT(text, testing::HasSubstr("\nA\t1\tFREE\tFREE\tEXPLICIT\n"));
  EXPECT_THAT(text, testing::EndsWith("MTG :\nENTITY-CODE\t\n"));
}

TEST(WriteWholeMtg, RefusesAParentInAnUnrelatedUnit) {
  Mtg mtg = readMtgRows("/P1/A1/E1\n/P2/A2/E2\n").value;
  mtg.vertices[5].parent = VertexId{2}; // E2 on E1, while A2 is not attached to A1
  EXPECT_THAT(refusalOf(mtg), testing::HasSubstr("E2 of scale 3 is attached to E1"));
}

TEST(WriteWholeMtg, KeepsThreeSuccessorsOfAVertex) {
  Mtg mtg = readMtgRows("/P1/A1/E1\n").value;
  for (int i = 2; i < 5; ++i)
    mtg.vertices.push_back(
        {.symbol = "E", .index = i, .scale = 3, .complex = VertexId{1}, .parent = VertexId{2}});
  expectRoundTrip(mtg);
  EXPECT_THAT(openAleaLimits(mtg), testing::ElementsAre(testing::HasSubstr("three successors")));
}

/// Three scales, each vertex a part of its parent's unit or the first of a new one.
Mtg randomMtg(std::size_t size, std::uint64_t seed) {
  Random random(seed);
  Mtg mtg = readMtgRows("/P1/A1/E1\t\t\t0\t1\t2\n").value;
  std::vector<VertexId> finest = {VertexId{2}};
  const auto add = [&](MtgVertex vertex) {
    mtg.vertices.push_back(std::move(vertex));
    return VertexId{static_cast<std::uint32_t>(mtg.vertices.size() - 1)};
  };
  while (mtg.vertices.size() < size) {
    const VertexId parent = finest[random.below(finest.size())];
    VertexId complex = *mtg.vertices[indexOf(parent)].complex;
    const EdgeType edge = random.uniform() < 0.5 ? EdgeType::successor : EdgeType::branching;
    const int index = static_cast<int>(mtg.vertices.size());
    if (random.uniform() < 0.3)
      complex = add({.symbol = "A",
                     .index = index,
                     .scale = 2,
                     .complex = mtg.vertices[indexOf(complex)].complex,
                     .parent = complex,
                     .edge = edge});
    finest.push_back(add({.symbol = "E",
                          .index = index,
                          .scale = 3,
                          .complex = complex,
                          .parent = parent,
                          .edge = edge,
                          .values = {std::to_string(index)}}));
  }
  return mtg;
}

TEST(WriteWholeMtg, AndReadingGivesTheSameOfAnyPlant) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    expectRoundTrip(randomMtg(100, seed));
}

TEST(OpenAleaLimits, NamesTypesSymbolsAndValues) {
  Mtg mtg = readMtgRows("/P1\t\t\t1\t2\t3\tx=(4)\n").value;
  mtg.features.push_back({"alive", "BOOLEAN"});
  mtg.classes.push_back({.symbol = "B_2", .scale = 2});
  EXPECT_THAT(openAleaLimits(mtg),
              testing::ElementsAre(testing::HasSubstr("'B_2'"), testing::HasSubstr("'BOOLEAN'"),
                                   testing::HasSubstr("'x=(4)' of radius at P1")));
  mtg = readMtgRows("/P1\t\t\t1\t2\t3\t24/08/2022\n").value;
  EXPECT_THAT(openAleaLimits(mtg), testing::IsEmpty()) << "a date is safe";
}

TEST(OpenAleaLimits, NamesSkippedScalesAndTheScene) {
  EXPECT_THAT(openAleaLimits(readMtgRows("/P1/E1\n").value),
              testing::ElementsAre(testing::HasSubstr("1 vertices skip a scale")));
  EXPECT_THAT(openAleaLimits(readMtgRows("/Scene0/P1/A1/E1\n").value),
              testing::ElementsAre(testing::HasSubstr("the scene is a vertex")));
  EXPECT_THAT(openAleaLimits(readMtgRows("/P1/A1/E1\n").value), testing::IsEmpty());
}

} // namespace
} // namespace espalier
