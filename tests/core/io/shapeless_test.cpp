// A plant without its shape: an MTG none of whose vertices has a position.
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/dropped.h"
#include "core/io/formats.h"
#include "core/io/structures/opf.h"
#include "core/mtg/mtg_edits.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_writer.h"
#include "tests/core/io/samples.h"
#include "tests/core/mtg/hand_typed.h"
#include "tests/support/shared_data.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <sstream>

namespace espalier {
namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Mtg importShapeless(const std::string& text) {
  std::istringstream in(text);
  return readMtg(in, "plant.mtg").value;
}

/// The first of the texts that are typed by hand: shoots numbered by places, without positions.
const std::string& shoots() {
  return test::handTypedTexts().front().text;
}

struct Shapeless : testing::Test {
  fs::path folder = test::freshFolder();
  fs::path typed = folder / "typed.mtg";

  Shapeless() {
    writeAtomically(typed, [](std::ostream& out) { out << shoots(); });
  }
  std::string refusalToWrite(const char* name) {
    const Structure plant = readAnyStructure(typed).value;
    return test::errorOf([&] { writeStructure(folder / name, plant); });
  }
};

TEST_F(Shapeless, IsReadWithANoteAndWrittenAsItWas) {
  const Imported<Structure> plant = readAnyStructure(typed);
  EXPECT_TRUE(isWithoutPositions(plant.value));
  EXPECT_TRUE(plant.value.skeleton.isEmpty());
  EXPECT_THAT(
      eachInEnglish(plant.notes),
      testing::ElementsAre(typed.string() + ": has no positions: it is a plant without its shape"));
  writeStructure(folder / "copy.mtg", plant.value);
  EXPECT_EQ(bytesOf(folder / "copy.mtg"), shoots());
}

TEST_F(Shapeless, IsRefusedInOneLineWhereAShapeIsNeeded) {
  EXPECT_THAT(
      test::errorOf([&] { return readStructure(typed); }),
      testing::EndsWith(
          "/typed.mtg: none of its vertices has a position, in features XX, YY and ZZ: it "
          "describes a plant without its shape, which can be shown, reported (info) and written "
          "as MTG or OPF"));
  EXPECT_THAT(refusalToWrite("a.swc"),
              testing::EndsWith(
                  "/a.swc: SWC needs positions, and the structure has none: choose MTG or OPF"));
  for (const char* name : {"a.graphml", "a.rsml", "a.obj", "a.txt", "a.internodes.csv"})
    EXPECT_THAT(refusalToWrite(name), testing::HasSubstr("needs positions")) << name;
  EXPECT_FALSE(fs::exists(folder / "a.swc")) << "nothing half written";
}

TEST_F(Shapeless, IsWrittenAsOpfWithItsScalesEdgesAndFeatures) {
  const Structure plant = readAnyStructure(typed).value;
  writeStructure(folder / "plant.opf", plant);
  const Structure back = readAnyStructure(folder / "plant.opf").value;
  ASSERT_TRUE(isWithoutPositions(back));
  const std::vector<MtgVertex> expected = mtgAsWritten(plant.frame->mtg).vertices;
  const std::vector<MtgVertex>& read = mtgAsWritten(back.frame->mtg).vertices;
  ASSERT_EQ(read.size(), expected.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].symbol, expected[i].symbol);
    EXPECT_EQ(read[i].scale, expected[i].scale);
    EXPECT_EQ(read[i].complex, expected[i].complex);
    EXPECT_EQ(read[i].parent, expected[i].parent);
    EXPECT_EQ(read[i].edge, expected[i].edge);
    EXPECT_EQ(read[i].values, expected[i].values);
  }
  const Format& opf = formatToWrite("plant.opf", Content::structure);
  EXPECT_THAT(eachInEnglish(droppedBy(opf, plant)),
              testing::ElementsAre(testing::HasSubstr("keeps no labels")));
}

// What is drawn into it is kept beside what was there.
TEST_F(Shapeless, TakesNodesBesideItsVertices) {
  const Mtg base = importShapeless(shoots());
  Skeleton drawn;
  const NodeId foot = drawn.add({.position = {0, 0, 0}});
  drawn.add({.position = {0, 0, 1}, .parent = foot});
  const Mtg edited = withEdits(base, drawn);
  ASSERT_EQ(edited.vertices.size(), base.vertices.size() + 2);
  std::ostringstream out;
  writeMtg(out, edited);
  const Mtg back = importShapeless(out.str());
  EXPECT_EQ(back, mtgAsWritten(edited));
  std::size_t placed = 0;
  for (const MtgVertex& vertex : back.vertices)
    placed += vertex.scale == 3 && vertex.values.size() > 4 && !vertex.values[4].empty() ? 1 : 0;
  EXPECT_EQ(placed, 2U);
}

TEST(ShapelessSamples, AreAllConvertedToMtgAndOpf) {
  ESPALIER_SHARED_FILE(table, "mtg/openalea_counts.tsv");
  const fs::path folder = test::freshFolder();
  int files = 0;
  int shapeless = 0;
  for (const auto& entry : fs::directory_iterator(table.parent_path())) {
    if (entry.path().extension() != ".mtg") continue;
    ++files;
    const std::string name = entry.path().filename().string();
    const Structure plant = readAnyStructure(entry.path()).value;
    writeStructure(folder / name, plant);
    EXPECT_EQ(bytesOf(folder / name), bytesOf(entry.path())) << name;
    const Structure anew{plant.skeleton,
                         std::make_shared<const MtgFrame>(MtgFrame{plant.frame->mtg, {}})};
    writeStructure(folder / ("anew_" + name), anew);
    EXPECT_EQ(mtgAsWritten(importShapeless(bytesOf(folder / ("anew_" + name)))),
              mtgAsWritten(plant.frame->mtg))
        << name;
    if (!isWithoutPositions(plant)) continue;
    ++shapeless;
    writeStructure(folder / (name + ".opf"), plant);
    EXPECT_EQ(readAnyStructure(folder / (name + ".opf")).value.frame->mtg.vertices.size(),
              plant.frame->mtg.vertices.size() -
                  std::size_t(std::ranges::count(plant.frame->mtg.vertices, 0, &MtgVertex::scale)))
        << name;
  }
  EXPECT_EQ(files, 20);
  EXPECT_EQ(shapeless, 17);
}

TEST(Formats, NameTextOfTwoBytesPerCharacter) {
  const fs::path folder = test::freshFolder();
  std::string wide = "\xFF\xFE";
  for (const char c : shoots())
    wide += std::string{c, '\0'};
  for (const char* name : {"plant.mtg", "scan.xyz", "unknown"}) {
    writeAtomically(folder / name, [&](std::ostream& out) { out << wide; });
    EXPECT_EQ(test::errorOf([&] { return readAnyStructure(folder / name); }),
              (folder / name).string() +
                  ": is text of two bytes per character (UTF-16, \"Unicode Text\" in Excel), which "
                  "cannot be read: save it as UTF-8, or in Excel as \"Text (Tab delimited)\"");
  }
}

} // namespace
} // namespace espalier
