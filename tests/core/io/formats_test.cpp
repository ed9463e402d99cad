#include "core/io/atomic_file.h"
#include "core/io/formats.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/skeleton/assemble_axes.h"
#include "tests/core/io/plantgl/bgeom_writer.h"
#include "tests/core/io/plantgl/pickle_writer.h"
#include "tests/core/io/points/e57_writer.h"
#include "tests/core/io/points/laz_writer.h"
#include "tests/core/io/qsm/mat_writer.h"
#include "tests/core/io/qsm/qsm_samples.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <limits>
#include <sstream>
#include <unistd.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

fs::path fileOf(const std::string& name, const std::string& bytes) {
  fs::path path = test::freshFolder() / name;
  writeAtomically(path, [&](std::ostream& out) { out << bytes; });
  return path;
}

std::string errorOfPoints(const fs::path& path) {
  return test::errorOf([&] { return readPoints(path); });
}

std::string errorOfStructure(const fs::path& path) {
  return test::errorOf([&] { return readStructure(path); });
}

TEST(Formats, AreReadByContentWhateverTheExtension) {
  const std::vector<std::pair<std::string, std::string>> samples = {
      {"PLY", test::plyFile(std::endian::big)},
      {"LAS", test::lasFile({})},
      {"LAZ", test::lazFile(test::lasFile({}))},
      {"PCD", test::pcdFile(test::PcdKind::binary)},
      {"E57", test::e57SampleFile()},
      {"PTX", test::ptxFile()},
      {"MTG", test::mtgFile()},
      {"BGEOM", test::bgeomFile()},
      {"BMTG", test::bmtgFile()},
      {"QSM table", test::treeQsmTable()},
      {"QSM", test::qsmMatFile()},
      {"node list", test::nodeListFile()},
      {"SWC", test::swcFile()},
      {"treefile", test::treefileFile()},
      {"GraphML", test::graphmlFile()},
      {"OPF", test::opfFile()},
      {"RSML", test::rsmlFile()}};
  for (const auto& [name, bytes] : samples) {
    EXPECT_EQ(formatOf(fileOf("wrong.csv", bytes)).name, name);
    EXPECT_EQ(formatOf(fileOf("none", bytes)).name, name);
  }
  EXPECT_EQ(formatOf(fileOf("points.TXT", "1 2 3\n")).name, "XYZ");
  EXPECT_EQ(formatOf(fileOf("points.geom", test::geomFile())).name, "GEOM");
}

TEST(Formats, ShowWhetherAFileHoldsPointsOrAStructure) {
  EXPECT_EQ(formatOf(fileOf("a.ply", test::asciiPlyFile())).content, Content::points);
  EXPECT_EQ(formatOf(fileOf("a.txt", test::nodeListFile())).content, Content::structure);
}

TEST(Formats, SeparatePointsFromStructures) {
  EXPECT_THAT(errorOfPoints(fileOf("oak.mtg", test::mtgFile())),
              EndsWith("/oak.mtg: holds a structure (MTG), not points: choose a scan"));
  EXPECT_THAT(
      errorOfStructure(fileOf("oak.ply", test::asciiPlyFile())),
      EndsWith("/oak.ply: holds points (PLY), not a structure: choose an MTG or a node list"));
}

TEST(Formats, ListWhatCanBeReadInstead) {
  EXPECT_THAT(errorOfPoints(fileOf("oak.docx", "PK")), HasSubstr("PLY (.ply), XYZ (.xyz .asc"));
  EXPECT_THAT(errorOfPoints(fileOf("oak.laz", "anything")), HasSubstr("is no LAS file"));
}

TEST(Formats, ReportWhyAFileCannotBeOpened) {
  const fs::path folder = test::freshFolder();
  EXPECT_EQ(errorOfPoints(folder), folder.string() + ": is a folder, choose a file in it");
  EXPECT_THAT(errorOfPoints(folder / "missing.ply"), HasSubstr("there is no such file"));
  EXPECT_THAT(errorOfPoints(fileOf("file", "text") / "oak.ply"),
              HasSubstr("there is no such file"));
  EXPECT_THAT(errorOfPoints(fileOf("empty.ply", "")),
              EndsWith("/empty.ply: is empty: copy or export it again"));
  EXPECT_THAT(errorOfStructure(fileOf("empty.mtg", " \n")),
              EndsWith("/empty.mtg: is empty: copy or export it again"));
}

TEST(Formats, ReportThatAFileMayNotBeRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read anything";
  const fs::path path = fileOf("oak.xyz", "1 2 3\n");
  fs::permissions(path, fs::perms::none);
  EXPECT_THAT(errorOfPoints(path), HasSubstr("may not be read: change its rights"));
}

TEST(ReadPoints, ReadsLaz) {
  const std::string las = test::lasFile({.format = 3});
  const PointCloud plain = readPoints(fileOf("oak.las", las)).value;
  const PointCloud packed = readPoints(fileOf("oak.laz", test::lazFile(las))).value;
  EXPECT_EQ(packed.positions(), plain.positions());
  EXPECT_EQ(packed.origin(), plain.origin());
}

TEST(ReadPoints, LeavesOutWhatIsNotFiniteAndSaysSo) {
  const Imported<PointCloud> cloud =
      readPoints(fileOf("scan.xyz", "1 2 3\nnan 5 6\n7 8 9\n1 inf 3\n"));
  EXPECT_EQ(cloud.value.size(), 2);
  EXPECT_THAT(eachInEnglish(cloud.notes),
              ElementsAre(HasSubstr("scan.xyz: 2 of 4 points are not finite")));
  EXPECT_THAT(errorOfPoints(fileOf("scan.xyz", "nan nan nan\n")),
              EndsWith("/scan.xyz: holds 1 point, none of them finite: export it again"));
}

TEST(ReadPoints, TakesOnePointAndPointsThatCoincide) {
  EXPECT_EQ(readPoints(fileOf("one.xyz", "1 2 3\n")).value.size(), 1);
  const PointCloud same = readPoints(fileOf("same.xyz", "1 2 3\n1 2 3\n1 2 3\n")).value;
  EXPECT_EQ(same.size(), 3);
  EXPECT_EQ(same.position(2), Eigen::Vector3d(1, 2, 3));
}

TEST(ReadPoints, RefusesAFileWithoutAny) {
  std::string bytes = test::asciiPlyFile();
  bytes.replace(bytes.find("vertex 3"), 8, "vertex 0");
  EXPECT_THAT(errorOfPoints(fileOf("oak.ply", bytes)),
              EndsWith("/oak.ply: holds no points: export it again"));
}

TEST(ReadPoints, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)readPoints(fileOf("oak.xyz", "1 2 3\n"), Progress(stop.get_token(), {})),
               Cancelled);
}

TEST(ReadPoints, FindsOneTreeInItsThreeFormats) {
  ESPALIER_SHARED_FILE(las, "las/tree.las");
  ESPALIER_SHARED_FILE(ply, "las/tree.ply");
  ESPALIER_SHARED_FILE(txt, "las/tree.txt");
  const auto inFileOrder = [](const PointCloud& cloud) {
    std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(cloud.size()));
    for (Eigen::Index i = 0; i < cloud.size(); ++i)
      points[cloud.fileOrder()[static_cast<std::size_t>(i)]] = cloud.position(i);
    return points;
  };
  const auto a = inFileOrder(readPoints(las).value);
  const auto b = inFileOrder(readPoints(ply).value);
  const auto c = inFileOrder(readPoints(txt).value);
  ASSERT_EQ(a.size(), 30826U);
  ASSERT_EQ(b.size(), a.size());
  ASSERT_EQ(c.size(), a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_LT((a[i] - b[i]).norm(), 0.001) << i;
    ASSERT_LT((b[i] - c[i]).norm(), 0.001) << i;
  }
}

TEST(WritePoints, AndReadingGivesTheSameCloudInEachFormat) {
  const PointCloud cloud = readPoints(fileOf("oak.xyz", test::xyzFile())).value;
  const fs::path folder = test::freshFolder();
  for (const Format& format : formats()) {
    if (format.writePoints == nullptr) continue;
    for (const std::string_view extension : format.extensions) {
      const fs::path path = folder / ("oak." + std::string(extension));
      writePoints(path, cloud);
      const Imported<PointCloud> back = readPoints(path);
      EXPECT_EQ(back.value.positions(), cloud.positions()) << path;
      EXPECT_EQ(back.value.colors(), cloud.colors()) << path;
      EXPECT_EQ(back.value.intensities(), cloud.intensities()) << path;
      EXPECT_THAT(back.notes, IsEmpty());
    }
  }
}

// Asked while points are written: once a first part of them is.
TEST(WritePoints, StopsWhenAskedAndLeavesTheOldFile) {
  const std::string old = "1 2 3\n";
  RawPoints raw;
  for (int i = 0; i < 200'000; ++i)
    raw.positions.emplace_back(i, 0.1 * i, 0.01 * i);
  const PointCloud cloud(std::move(raw));
  for (const Format& format : formats()) {
    if (format.writePoints == nullptr) continue;
    const fs::path path = fileOf("oak." + std::string(format.extensions.front()), old);
    std::stop_source stop;
    double reached = 0;
    const Progress progress(stop.get_token(), [&](double fraction, std::string_view) {
      reached = fraction;
      if (fraction > 0.5) stop.request_stop();
    });
    EXPECT_THROW(writePoints(path, cloud, progress), Cancelled) << path;
    EXPECT_GT(reached, 0.5);
    EXPECT_LT(reached, 0.9) << format.name;
    EXPECT_EQ(fs::file_size(path), old.size());
    EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), {}), 1);
  }
}

/// Writes a plant in each format that can be read again, and expects the same plant back, but for
/// what an MTG says of it. Its axes must be assembled, as readers do where a format does not keep
/// them.
void expectSameInEachFormat(const Skeleton& plant) {
  const Skeleton expected = test::canonical(test::withoutEntities(plant));
  const fs::path folder = test::freshFolder();
  int formatsRead = 0;
  for (const Format& format : formats()) {
    if (format.writeStructure == nullptr || !format.canRead()) continue;
    ++formatsRead;
    const fs::path path = folder / ("oak." + std::string(format.extensions.front()));
    writeStructure(path, plant);
    EXPECT_EQ(formatOf(path).name, format.name);
    const Skeleton back = test::withoutEntities(readStructure(path).value.skeleton);
    EXPECT_TRUE(test::canonical(back) == expected) << path;
  }
  EXPECT_GE(formatsRead, 7);
}

TEST(WriteStructure, AndReadingGivesTheSamePlantInEachFormat) {
  expectSameInEachFormat(withAssembledAxes(test::randomPlant(100, 3)));
}

TEST(WriteStructure, AndReadingGivesTheSamePineInEachFormat) {
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Skeleton pine = readStructure(expert).value.skeleton;
  ASSERT_EQ(pine.size(), 3358U);
  expectSameInEachFormat(withAssembledAxes(pine));
}

TEST(WriteStructure, ChangesTheMovedPositionInTheTextOfAnMtgAlone) {
  const std::string head =
      "CODE :\tFORM-A\n\nCLASSES :\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\t"
      "DEFINITION\n$\t0\tFREE\tFREE\tIMPLICIT\nP\t1\tFREE\tFREE\tEXPLICIT\n"
      "E\t2\tFREE\tFREE\tEXPLICIT\n\nDESCRIPTION :\nLEFT\tRIGHT\tRELTYPE\tMAX"
      "\n\nFEATURES :\nNAME\tTYPE\nXX\tREAL\nYY\tREAL\nZZ\tREAL\nstate\tALPHA\n"
      "\nMTG :\nENTITY-CODE\t\tXX\tYY\tZZ\tstate\n";
  const std::string text =
      head + "/P1\t\t\t\t\told # by hand\n^/E1\t\t0.00\t0\t0\n^<E2\t\t0\t1.50\t0\tD\n";
  const fs::path path = test::freshFolder() / "oak.mtg";
  std::ofstream(path) << text;
  Structure oak = readStructure(path).value;
  oak.skeleton.setPosition(NodeId{1}, {0, 1.5, 0.25});
  writeStructure(path, oak);
  std::ifstream in(path);
  const std::string saved((std::istreambuf_iterator<char>(in)), {});
  EXPECT_EQ(saved, head + "/P1\t\t\t\t\told # by hand\n^/E1\t\t0.00\t0\t0\n"
                          "^<E2\t\t0\t1.50\t0.25\tD\n");
}

TEST(WriteStructure, ReportsThatTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  EXPECT_THAT(test::errorOf([] {
                writeStructure("/dev/full", test::stick(3));
                return 0;
              }),
              HasSubstr("No space left on device"));
}

TEST(WriteStructure, LeavesTheOldFileIfThePlantCannotBeWritten) {
  const fs::path path = test::freshFolder() / "oak.mtg";
  writeStructure(path, test::stick(3));
  Skeleton broken = test::stick(3);
  broken.setPosition(NodeId{1}, {0, 0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_NE(test::errorOf([&] {
              writeStructure(path, broken);
              return 0;
            }),
            "");
  EXPECT_EQ(readStructure(path).value.skeleton.size(), 3U);
}

TEST(FormatToWrite, NamesTheExtensionsThereAre) {
  EXPECT_EQ(formatToWrite("a.txt", Content::points).name, "XYZ");
  EXPECT_EQ(formatToWrite("a.txt", Content::structure).name, "node list");
  EXPECT_EQ(formatToWrite("a.csv", Content::points).name, "XYZ");
  EXPECT_EQ(formatToWrite("a.csv", Content::structure).name, "QSM table");
  EXPECT_EQ(formatToWrite("a.internodes.csv", Content::structure).name, "internodes");
  EXPECT_EQ(formatToWrite("a.obj", Content::structure).name, "OBJ surface");
  EXPECT_EQ(formatToWrite("a.LINES.obj", Content::structure).name, "OBJ lines");
  EXPECT_THAT(test::errorOf([] { return formatToWrite("oak.las", Content::structure).name; }),
              StartsWith("oak.las: a structure cannot be written with this extension; choose one "
                         "of MTG (.mtg), node list (.txt), SWC (.swc)"));
  EXPECT_THAT(test::errorOf([] { return formatToWrite("oak.las", Content::points).name; }),
              HasSubstr("PLY (.ply), XYZ ("));
}

TEST(FormatToWrite, IsThatOfTheFileWhichIsThereWhereSeveralShareAnExtension) {
  const fs::path path = test::freshFolder() / "oak.txt";
  for (const Format& format : formats()) {
    if (format.writeStructure == nullptr || !format.canRead()) continue;
    if (std::ranges::find(format.extensions, "txt") == format.extensions.end()) continue;
    writeStructure(path, Structure{.skeleton = test::fork(3), .frame = {}}, format);
    EXPECT_EQ(formatToWrite(path, Content::structure).name, format.name);
    EXPECT_EQ(formatToWrite(path, Content::points).name, "XYZ");
  }
  std::ofstream(path) << "1 2 3\n4 5 6\n";
  EXPECT_EQ(formatToWrite(path, Content::structure).name, "node list") << "points are none";
  std::ofstream(path, std::ios::trunc).close();
  EXPECT_EQ(formatToWrite(path, Content::structure).name, "node list");
}

// The branch comes before the successor: lines of MTG text have them the other way round.
TEST(ReadStructure, GivesAnMtgThatCameWithoutATextOneThatKeepsItsIds) {
  const std::filesystem::path file = test::freshFolder() / "plant.opf";
  Skeleton plant;
  const NodeId foot = plant.add({});
  const NodeId branch =
      plant.add({.position = {1, 0, 1}, .parent = foot, .edge = EdgeType::branching});
  plant.add({.position = {2, 0, 1}, .parent = branch});
  plant.add({.position = {0, 0, 1}, .parent = foot});
  plant.add({.position = {3, 0, 1}, .parent = branch, .edge = EdgeType::branching});
  writeStructure(file, plant);
  const Structure opened = readStructure(file).value;
  ASSERT_NE(opened.frame, nullptr);
  std::istringstream text(opened.frame->text);
  const Mtg again = readMtg(text, "again").value;
  EXPECT_EQ(again, opened.frame->mtg);
  EXPECT_EQ(skeletonOf(again, "again").value, opened.skeleton) << "ids are the same";
  EXPECT_EQ(opened.skeleton.size(), plant.size());
}

} // namespace
} // namespace espalier
