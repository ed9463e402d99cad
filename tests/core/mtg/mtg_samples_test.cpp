// The MTG files of others: each is read as its programs read it, and survives being written.
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_writer.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/shared_data.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <map>
#include <sstream>

namespace espalier {
namespace {

Imported<Mtg> readSample(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return readMtg(in, path.filename().string());
}

/// "vertices per scale, from the scene on; edges <; edges +", as in the table of counts.
std::string countsOf(const Mtg& mtg) {
  std::vector<std::size_t> vertices = {1};
  std::size_t successors = 0;
  std::size_t branchings = 0;
  for (const MtgVertex& each : mtg.vertices) {
    const auto scale = static_cast<std::size_t>(each.scale);
    vertices.resize(std::max(vertices.size(), scale + 1));
    if (scale > 0) ++vertices[scale];
    if (each.parent) ++(each.edge == EdgeType::successor ? successors : branchings);
  }
  std::string text;
  for (const std::size_t count : vertices)
    text += (text.empty() ? "" : ",") + std::to_string(count);
  return text + '\t' + std::to_string(successors) + '\t' + std::to_string(branchings);
}

struct Sample {
  std::string file;
  std::string counts = {}; // where OpenAlea is wrong by the specification; else those of OpenAlea
  std::size_t notes = 0;
};

void PrintTo(const Sample& sample, std::ostream* out) {
  *out << sample.file;
}

class MtgSample : public testing::TestWithParam<Sample> {};

/// What openalea.mtg counts in a file; nothing if that was not measured.
std::string countsOfOpenAlea(const std::filesystem::path& table, const std::string& file) {
  std::ifstream in(table);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(file + '\t')) return line.substr(file.size() + 1);
  return "";
}

TEST_P(MtgSample, HasItsVerticesAndEdges) {
  ESPALIER_SHARED_FILE(path, "mtg/" + GetParam().file);
  ESPALIER_SHARED_FILE(table, "mtg/openalea_counts.tsv");
  const std::string expected =
      GetParam().counts.empty() ? countsOfOpenAlea(table, GetParam().file) : GetParam().counts;
  const Imported<Mtg> mtg = readSample(path);
  EXPECT_EQ(countsOf(mtg.value), expected);
  EXPECT_EQ(mtg.notes.size(), GetParam().notes) << testing::PrintToString(eachInEnglish(mtg.notes));
}

TEST_P(MtgSample, SurvivesReadingAndWriting) {
  ESPALIER_SHARED_FILE(path, "mtg/" + GetParam().file);
  const Mtg mtg = readSample(path).value;
  const std::string text = test::written(mtg);
  std::istringstream in(text);
  const Mtg back = readMtg(in, "back").value;
  EXPECT_EQ(back, mtgAsWritten(mtg)) << text;
  EXPECT_EQ(test::written(back), text);
  EXPECT_EQ(countsOf(back), countsOf(mtg));
}

// code_file: its classes U and I are both of scale 3, none of scale 2 occurs; OpenAlea puts the
// first U just below its plant. Five values stand left of their columns there. code_file3: three of
// its comment lines hold codes. mtg_fig32: F is of scale 5; OpenAlea puts all 12 at scale 3. S is
// not declared; OpenAlea passes both over. Of the edges, 3 + 3 follow (A92, U2); 13 A branch, as do
// the first parts of five of them that stand at the scale of what bears them (U1 twice, S1 twice,
// I10). Five U branch from units that hold no other U, so these are attached to nothing. The files
// jl_ were not measured; these are the vertices and edges of their lines.
INSTANTIATE_TEST_SUITE_P(
    All, MtgSample,
    testing::Values(Sample{"code_file.mtg", "1,1,0,34\t27\t1", 5}, Sample{"code_file2.mtg"},
                    Sample{.file = "code_file3.mtg", .notes = 1}, Sample{"monopodial_plant.mtg"},
                    Sample{"mtg1.mtg"}, Sample{"mtg2.mtg"}, Sample{"mtg3.mtg"}, Sample{"mtg4.mtg"},
                    Sample{"mtg5.mtg"}, Sample{"mtg_dynamic.mtg"},
                    Sample{"mtg_fig32.mtg", "1,1,17,13,18,12\t6\t18", 6},
                    Sample{"reconstructed_appletree.mtg"}, Sample{"test6_apricot2.mtg"},
                    Sample{"test7.mtg"}, Sample{"test8_boutdenoylum2.mtg"},
                    Sample{"jl_palm.mtg", "1,1,2,1,2\t0\t1", 2},
                    Sample{"jl_simple_plant.mtg", "1,1,1,4\t1\t2", 1},
                    Sample{"jl_simple_plant-P1U1.mtg", "1,1,1,4\t1\t2", 1},
                    Sample{"jl_simple_plant-blanks.mtg", "1,1,1,4\t1\t2", 1},
                    Sample{"jl_simple_plant-follow.mtg", "1,1,3,6,25\t22\t6"}));

// Its dates are lines of their own, which a table of vertices alone would lose.
TEST(MtgSamples, OfSeveralDatesKeepThem) {
  ESPALIER_SHARED_FILE(path, "mtg/mtg_dynamic.mtg");
  const Mtg mtg = readSample(path).value;
  const MtgVertex& trunk = mtg.vertices[2]; // after /b105 and /L1
  ASSERT_EQ(trunk.symbol, "U");
  ASSERT_EQ(trunk.later.size(), 2U);
  EXPECT_EQ(trunk.values[1], "16/07/2007");
  EXPECT_EQ(trunk.later[0][1], "31/12/2007");
  EXPECT_EQ(trunk.later[1][1], "01/12/2008");
  EXPECT_EQ(trunk.later[1][6], "39.90");
  EXPECT_THAT(test::written(mtg), testing::HasSubstr("\n*\t"));
}

} // namespace
} // namespace espalier
