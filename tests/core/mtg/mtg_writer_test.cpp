#include "core/base/error.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_writer.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <limits>
#include <sstream>

namespace espalier {
namespace {

std::string writtenOf(const Skeleton& skeleton) {
  std::ostringstream out;
  writeMtg(out, skeleton);
  return out.str();
}

Skeleton readBack(const std::string& text) {
  std::istringstream in(text);
  return skeletonOf(readMtg(in, "plant.mtg").value, "plant.mtg").value;
}

/// Reading what was writtenOf gives the plant back, all its numbers bit for bit.
void expectRoundTrip(const Skeleton& plant) {
  EXPECT_EQ(test::canonical(test::withoutEntities(readBack(writtenOf(plant)))),
            test::canonical(test::withoutEntities(plant)));
}

/// The lines of the section MTG after that of the columns.
std::vector<std::string> rowsOf(const std::string& text) {
  std::istringstream in(text.substr(text.find("ENTITY-CODE")));
  std::vector<std::string> rows;
  for (std::string row; std::getline(in, row);)
    rows.push_back(row);
  rows.erase(rows.begin());
  return rows;
}

TEST(WriteMtg, WritesPlantsAsPlantScan3DDoes) {
  Skeleton plant = test::fork(2);
  plant.setPosition(NodeId{2}, {0.25, -1e-7, 3});
  plant.setPosition(NodeId{3}, {100000, 2, 3});
  plant.setRadius(NodeId{3}, 0);
  EXPECT_THAT(rowsOf(writtenOf(plant)),
              testing::ElementsAre("/P1\t\t\t\t\t", "^/N\t\t0\t0\t0\t0.1", "^<N\t\t0\t0\t1\t0.1",
                                   "\t+N\t100000\t2\t3\t", "^<N\t\t0.25\t-0.0000001\t3\t0.1"));
}

TEST(WriteMtg, AndReadingGivesTheSamePlant) {
  expectRoundTrip(test::stick(1));
  expectRoundTrip(test::fork(3));
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    expectRoundTrip(test::randomPlant(200, seed));
}

TEST(WriteMtg, KeepsEveryBitOfANumber) {
  Skeleton plant;
  plant.add({.position = {5e-324, -999999999999.99988, 1.0 / 3}, .radius = 1e-300});
  plant.add({.position = {-0.0, 1e12, 123456789.123456789}, .radius = 1e12});
  const std::string text = writtenOf(plant);
  EXPECT_EQ(test::canonical(test::withoutEntities(readBack(text))), test::canonical(plant));
  EXPECT_TRUE(std::signbit(readBack(text)[NodeId{1}].position.x()));
}

TEST(WriteMtg, WritesAPlantPerRoot) {
  const std::string text = writtenOf(test::randomPlant(3, 1)); // two roots
  EXPECT_THAT(text, testing::HasSubstr("\n/P1\t"));
  EXPECT_THAT(text, testing::HasSubstr("\n/P2\t"));
}

// Readers of OpenAlea take values apart at these signs, and need all features in adjacent columns.
TEST(WriteMtg, WritesWhatOpenAleaReads) {
  const std::string text = writtenOf(test::randomPlant(300, 7));
  const std::string header =
      text.substr(text.find("ENTITY-CODE"), text.find("/P1") - text.find("ENTITY-CODE"));
  const auto columns = std::count(header.begin(), header.end(), '\t');
  EXPECT_THAT(header, testing::EndsWith("\tXX\tYY\tZZ\tradius\n"));
  for (const std::string& row : rowsOf(text)) {
    ASSERT_EQ(std::count(row.begin(), row.end(), '\t'), columns) << row;
    const std::string code = row.substr(0, row.find_first_of("0123456789-", row.find('N')));
    ASSERT_THAT(row, testing::MatchesRegex("\t*(/P[0-9]+|\\^/N|\\^?[<+]N)\t+[-0-9.\t]*")) << row;
    ASSERT_EQ(row.find("\t^+"), std::string::npos) << row;
  }
}

TEST(WriteMtg, WritesLongAxesWithoutRecursion) {
  expectRoundTrip(test::stick(20000, 0.001));
}

TEST(WriteMtg, WritesChainsOfBranchesInFewColumns) {
  Skeleton plant;
  std::optional<NodeId> parent;
  for (int i = 0; i < 5000; ++i)
    parent =
        plant.add({.position = {1.0 * i, 0, 0}, .parent = parent, .edge = EdgeType::branching});
  EXPECT_LT(writtenOf(plant).size(), 5000U * 100);
  expectRoundTrip(plant);
}

// A branch near the end of each axis, as in a root system nested 20 000 deep: a column for each
// would take 20 000 tabs a line.
TEST(WriteMtg, WritesDeeplyNestedBranchesInLinearSpace) {
  constexpr int depth = 20000;
  Skeleton plant;
  NodeId base = plant.add({});
  for (int i = 1; i <= depth; ++i) {
    plant.add({.position = {1.0 * i, 1, 0}, .parent = base});
    base = plant.add({.position = {1.0 * i, 0, 0}, .parent = base, .edge = EdgeType::branching});
  }
  EXPECT_LT(writtenOf(plant).size(), 2U * depth * 120);
  expectRoundTrip(plant);
  std::ostringstream out;
  writeMtg(out, mtgOf(plant, MtgStyle::plantAxisNode));
  EXPECT_LT(out.str().size(), 3U * depth * 120);
}

TEST(WriteMtg, KeepsTwoSuccessorsOfANode) {
  Skeleton plant = test::stick(3);
  plant.add({.position = {1, 1, 1}, .parent = NodeId{1}});
  plant.add({.position = {2, 1, 1}, .parent = NodeId{1}, .edge = EdgeType::branching});
  expectRoundTrip(plant);
}

TEST(WriteMtg, RefusesPositionsThatAreNotFinite) {
  Skeleton plant = test::stick(2);
  plant.setPosition(NodeId{1}, {0, std::numeric_limits<double>::quiet_NaN(), 0});
  std::ostringstream out;
  EXPECT_THROW(writeMtg(out, plant), Error);
  EXPECT_EQ(out.str(), "");
}

TEST(WriteMtg, KeepsThePinesOfTheExperts) {
  for (const char* name : {"puu1/expert.mtg", "structures/cherry_reference.mtg"}) {
    ESPALIER_SHARED_FILE(path, name);
    std::ifstream in(path);
    expectRoundTrip(skeletonOf(readMtg(in, name).value, name).value);
  }
}

} // namespace
} // namespace espalier
