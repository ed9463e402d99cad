#include "core/io/atomic_file.h"
#include "core/io/formats.h"
#include "core/io/glance.h"
#include "tests/core/io/plantgl/bgeom_writer.h"
#include "tests/core/io/points/e57_writer.h"
#include "tests/core/io/points/laz_writer.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/shared_data.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

fs::path glanceFile(const std::string& name, const std::string& bytes) {
  fs::path path = test::freshFolder() / name;
  writeAtomically(path, [&](std::ostream& out) { out << bytes; });
  return path;
}

bool takes(const PointGlance& glance, const std::string& column) {
  for (const GlanceColumn& each : glance.columns)
    if (each.name == column) return each.isTaken;
  return false;
}

// Of small files a glance and reading agree, whatever the format.
TEST(GlanceAt, CountsAndBoundsWhatIsRead) {
  const std::vector<std::pair<std::string, std::string>> samples = {
      {"a.ply", test::asciiPlyFile()},
      {"b.ply", test::plyFile(std::endian::big)},
      {"c.xyz", test::xyzFile()},
      {"d.las", test::lasFile({.minorVersion = 4, .format = 7})},
      {"e.laz", test::lazFile(test::lasFile({}))},
      {"f.pcd", test::pcdFile(test::PcdKind::ascii)},
      {"g.pcd", test::pcdFile(test::PcdKind::binary)},
      {"h.pcd", test::pcdFile(test::PcdKind::compressed)},
      {"i.e57", test::e57SampleFile()},
      {"j.geom", test::geomFile()},
      {"k.bgeom", test::bgeomFile()}};
  for (const auto& [name, bytes] : samples) {
    SCOPED_TRACE(name);
    const fs::path path = glanceFile(name, bytes);
    const PointGlance glance = glanceAt(path);
    const PointCloud cloud = readPoints(path).value;
    EXPECT_EQ(glance.points, static_cast<std::uint64_t>(cloud.size()));
    EXPECT_FALSE(glance.arePointsEstimated);
    EXPECT_EQ(takes(glance, "intensity") || takes(glance, "scalar_Intensity"),
              !cloud.intensities().empty());
    if (!glance.bounds.isEmpty()) {
      EXPECT_LT((glance.bounds.min() - cloud.bounds().min()).norm(), 1e-3);
      EXPECT_LT((glance.bounds.max() - cloud.bounds().max()).norm(), 1e-3);
    }
    EXPECT_EQ(glance.isReadWhole, name == "j.geom" || name == "k.bgeom");
    EXPECT_EQ(glance.isCompressed, name == "e.laz" || name == "h.pcd");
    EXPECT_FALSE(glance.up.reason.sentence.empty());
    EXPECT_FALSE(glance.unit.reason.sentence.empty());
  }
}

TEST(GlanceAt, TellsStationsAndWhatIsLeftOut) {
  EXPECT_EQ(glanceAt(glanceFile("a.e57", test::e57SampleFile())).stations, 2U);
  const PointGlance grid = glanceAt(glanceFile("a.ptx", test::ptxFile()));
  EXPECT_EQ(grid.stations, 2U);
  EXPECT_EQ(grid.unit.value, "m");
  EXPECT_TRUE(grid.unit.isStated);
  const PointGlance mesh = glanceAt(glanceFile("a.ply", test::plyFile(std::endian::little)));
  EXPECT_THAT(eachInEnglish(mesh.leftOut), Contains(HasSubstr("'face'")));
  EXPECT_FALSE(takes(glanceAt(glanceFile("a.las", test::lasFile({.format = 1}))), "gps_time"));
}

TEST(GlanceAt, SeesThePointsOfLasThatAreRead) {
  for (const test::LasSample& sample :
       {test::LasSample{.format = 1}, test::LasSample{.points = 50, .withheld = 7},
        test::LasSample{.minorVersion = 4, .format = 6, .points = 9, .extraBytes = 300}}) {
    const fs::path path = glanceFile("a.las", test::lasFile(sample));
    const PointGlance glance = glanceAt(path);
    const PointCloud cloud = readPoints(path).value;
    ASSERT_EQ(glance.sample.size(), static_cast<std::size_t>(cloud.size()));
    for (Eigen::Index i = 0; i < cloud.size(); ++i)
      EXPECT_LT((glance.sample[static_cast<std::size_t>(i)] - cloud.position(i)).norm(), 1e-3);
  }
}

TEST(GlanceAt, SeesSomePointsOfMuchLas) {
  const fs::path path = glanceFile("a.las", test::lasFile({.points = 40'000}));
  const PointGlance glance = glanceAt(path);
  EXPECT_EQ(glance.points, 40'000U);
  EXPECT_GT(glance.sample.size(), 10'000U);
  EXPECT_LT(glance.sample.size(), 20'000U);
  EXPECT_GT(glance.sample.back().z(), 100 + 100) << "also of its end"; // 3 mm apart
  fs::resize_file(path, fs::file_size(path) / 2);
  EXPECT_GT(glanceAt(path).sample.size(), 5000U) << "what is there";
}

TEST(GlanceAt, GuessesUnitAndAxisWithAReason) {
  std::string text;
  for (int i = 0; i < 2000; ++i) // a stem along y, 3 m high, and a crown as a disk on it
    text += std::to_string(i % 7) + ' ' + std::to_string(1.5 * (i % 2000)) + ' ' +
            std::to_string(i % 5) + '\n';
  for (int i = 0; i < 4000; ++i)
    text += std::to_string(1000 * std::cos(i) * (i % 50) / 50) + " 3000 " +
            std::to_string(1000 * std::sin(i) * (i % 50) / 50) + '\n';
  const PointGlance glance = glanceAt(glanceFile("oak.xyz", text));
  EXPECT_EQ(glance.unit.value, "mm");
  EXPECT_FALSE(glance.unit.isStated);
  EXPECT_EQ(inEnglish(glance.unit.reason), "in m it would be 3000 m large, as no plant is");
  EXPECT_EQ(glance.up.value, "y");
  EXPECT_EQ(inEnglish(glance.up.reason), "at the low end of y points stand together, as at a foot");
  const PointGlance map =
      glanceAt(glanceFile("map.xyz", "500001 4000002 100\n500011 4000007 130\n"));
  EXPECT_EQ(map.unit.value, "m");
  EXPECT_EQ(map.up.value, "z");
}

TEST(GlanceAt, GuessesNoUnitWhereASizeIsRareInEach) {
  const auto unitOf = [](double height) {
    return unitOfBounds({Eigen::Vector3d::Zero(), Eigen::Vector3d(0, height / 2, height)});
  };
  EXPECT_EQ(unitOf(3000), "mm");
  EXPECT_EQ(unitOf(38), "m");
  EXPECT_EQ(unitOf(0.3), "m");
  EXPECT_EQ(unitOf(0.01), "");
  EXPECT_EQ(unitOfBounds({}), "");
  const PointGlance glance = glanceAt(glanceFile("herb.xyz", "0 0 0\n3 4 46.2\n"));
  EXPECT_EQ(glance.unit.value, "");
  EXPECT_EQ(inEnglish(glance.unit.reason),
            "it would be 46.2 m, 46.2 cm or 46.2 mm large: choose which it is");
}

TEST(GlanceAt, EstimatesTheLinesOfALongText) {
  std::string text;
  for (int i = 0; i < 400'000; ++i)
    text += std::to_string(0.01 * (i % 1000)) + " 1.5 " + std::to_string(0.001 * i) + '\n';
  const PointGlance glance = glanceAt(glanceFile("long.xyz", text));
  EXPECT_TRUE(glance.arePointsEstimated);
  EXPECT_NEAR(static_cast<double>(glance.points), 400'000, 4000);
  EXPECT_TRUE(glance.areBoundsOfSample);
  EXPECT_NEAR(glance.bounds.max().z(), 400, 4);
}

// A file without its bytes: whoever read all of it would need 24 GB.
TEST(GlanceAt, NeverReadsALargeFile) {
  const fs::path path = glanceFile(
      "large.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 1000000000\n"
                   "property double x\nproperty double y\nproperty double z\nend_header\n");
  const auto header = fs::file_size(path);
  fs::resize_file(path, header + 24'000'000'000);
  const PointGlance glance = glanceAt(path);
  EXPECT_EQ(glance.points, 1'000'000'000U);
  EXPECT_TRUE(glance.areBoundsOfSample);
  EXPECT_LT(glance.sample.size(), 20'000U);
  fs::remove(path);
}

TEST(GlanceAt, RefusesBrokenHeadersAndStructures) {
  const auto refusal = [](const std::string& name, const std::string& bytes) {
    return test::errorOf([&] { return glanceAt(glanceFile(name, bytes)); });
  };
  EXPECT_THAT(refusal("a.mtg", test::mtgFile()), HasSubstr("holds a structure"));
  EXPECT_THAT(refusal("a.las", test::lasFile({}).substr(0, 100)), HasSubstr("ends within"));
  EXPECT_THAT(refusal("a.ply", "ply\nformat ascii 1.0\n"), HasSubstr("end_header"));
  std::string e57 = test::e57SampleFile();
  e57[e57.size() - 100] ^= 1;
  EXPECT_THAT(refusal("a.e57", e57), HasSubstr("does not fit its checksum"));
  EXPECT_THAT(refusal("a.ptx", "1\n1\n0 0 0\n"), HasSubstr("a.ptx, line 1"));
  EXPECT_THAT(refusal("a.xyz", "no points\n"), HasSubstr("holds no points"));
}

TEST(GlanceAt, ReadsTheHeaderOfCopc) {
  ESPALIER_SHARED_FILE(path, "laz/lone-star.copc.laz");
  const PointGlance glance = glanceAt(path);
  EXPECT_THAT(inEnglish(glance.version), HasSubstr("COPC, LAS 1.4"));
  EXPECT_EQ(glance.points, 518'862U);
  EXPECT_EQ(glance.unit.value, "m");
}

} // namespace
} // namespace espalier
