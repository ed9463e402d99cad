// Parts of scans: the same as if the file had been read whole, and then the part been taken.
#include "core/base/parallel.h"
#include "core/io/points/e57.h"
#include "core/io/points/las.h"
#include "core/io/points/laz.h"
#include "core/io/points/laz_layout.h"
#include "core/io/points/part_chooser.h"
#include "core/io/points/pcd.h"
#include "core/io/points/ply.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/ptx.h"
#include "core/io/points/xyz.h"
#include "tests/core/io/points/copc_writer.h"
#include "tests/core/io/points/e57_writer.h"
#include "tests/core/io/points/laz_writer.h"
#include "tests/core/io/samples.h"
#include "tests/support/shared_data.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <set>
#include <sstream>

namespace espalier {
namespace {

using Reader = ImportedPoints (*)(std::istream&, const std::string&, const ReadOptions&,
                                  const Progress&);

constexpr int pointsOfSample = 4000;
constexpr int columnsOfSample = 20;

/// Point i of the samples, in a cube of side 10 about (100, 200, 300), spread evenly (Roberts' R3
/// sequence). At multiples of 1/128: none lies within a rounding of the faces of boxes.
Eigen::Vector3d samplePlace(int i) {
  const Eigen::Array3d steps = i * Eigen::Array3d(0.8191725134, 0.6710436067, 0.5497004779);
  const Eigen::Array3d place = Eigen::Array3d(95, 195, 295) + 10 * (steps - steps.floor());
  return (place * 128).floor() / 128;
}

PointCloud sampleCloud() {
  RawPoints raw;
  for (int i = 0; i < pointsOfSample; ++i) {
    raw.positions.push_back(samplePlace(i));
    raw.intensities.push_back(static_cast<float>(i % 50));
    raw.colors.push_back({static_cast<std::uint8_t>(i % 256), 7, 9});
    raw.stationOf.push_back(static_cast<StationIndex>(i / 1500));
  }
  for (const char* name : {"north", "south", "west"})
    raw.stations.push_back({.name = name, .scanner = Eigen::Vector3d(1, 2, 3)});
  return PointCloud(std::move(raw));
}

std::string written(void (*write)(std::ostream&, const PointCloud&, const Eigen::Matrix3Xf&,
                                  const Progress&)) {
  const PointCloud cloud = sampleCloud();
  std::ostringstream out;
  write(out, cloud, cloud.positions(), {});
  return std::move(out).str();
}

void putPlace(std::string& las, const LasHeader& header, int point, const Eigen::Vector3d& place) {
  for (int axis = 0; axis < 3; ++axis)
    setValueAt(las.data() + header.pointStart + header.pointLength * std::size_t(point) +
                   std::size_t(4 * axis),
               static_cast<std::int32_t>(1000 * place[axis]));
}

/// A LAS file of so many points, in mm about 0.
std::string lasAboutZero(int format, int points) {
  std::string las =
      test::lasFile({.minorVersion = format >= 6 ? 4 : 2, .format = format, .points = points});
  for (std::size_t axis = 0; axis < 3; ++axis)
    setValueAt(las.data() + 155 + 8 * axis, 0.0);
  return las;
}

/// A LAS file with the places of the sample.
std::string sampleLas(int format) {
  std::string las = lasAboutZero(format, pointsOfSample);
  const LasHeader header = readLasHeader(las, "sample");
  for (int i = 0; i < pointsOfSample; ++i)
    putPlace(las, header, i, samplePlace(i));
  return las;
}

std::string sampleAsciiPly() {
  std::ostringstream out;
  out << "ply\nformat ascii 1.0\nelement vertex " << pointsOfSample
      << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (int i = 0; i < pointsOfSample; ++i)
    out << samplePlace(i).transpose() << '\n';
  return std::move(out).str();
}

std::string pcdHeader(const char* data) {
  return "VERSION 0.7\nFIELDS x y z intensity\nSIZE 8 8 8 4\nTYPE F F F F\nWIDTH " +
         std::to_string(pointsOfSample) + "\nHEIGHT 1\nDATA " + data + '\n';
}

std::string sampleBinaryPcd() {
  std::string bytes = pcdHeader("binary");
  for (int i = 0; i < pointsOfSample; ++i) {
    for (const double value : samplePlace(i))
      appendValue(bytes, value);
    appendValue(bytes, static_cast<float>(i));
  }
  return bytes;
}

std::string sampleAsciiPcd() {
  std::ostringstream out;
  out << pcdHeader("ascii");
  for (int i = 0; i < pointsOfSample; ++i)
    out << samplePlace(i).transpose() << ' ' << i << '\n';
  return std::move(out).str();
}

/// Three blocks, of which the last has no colors.
std::string samplePtx() {
  std::ostringstream out;
  for (int block = 0; block < 3; ++block) {
    out << columnsOfSample << "\n60\n1 2 3\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
        << block << " 0 0 1\n";
    for (int i = 0; i < 60 * columnsOfSample; ++i)
      out << samplePlace(i + 1200 * block).transpose() << " 0.5"
          << (block < 2 ? " 1 2 " + std::to_string(i % 256) : "") << '\n';
  }
  return std::move(out).str();
}

std::string sampleE57() {
  std::vector<test::E57Sample> scans;
  for (int scan = 0; scan < 2; ++scan) {
    std::vector<std::vector<double>> values(3);
    for (int i = 0; i < pointsOfSample / 2; ++i)
      for (int axis = 0; axis < 3; ++axis)
        values[std::size_t(axis)].push_back(samplePlace(i + 2000 * scan)[axis]);
    test::E57Sample sample{.columns = test::cartesianColumns(values[0], values[1], values[2])};
    sample.bytesPerPacket = 501; // values lie across packets
    scans.push_back(std::move(sample));
  }
  return test::e57File(scans);
}

struct PartSample {
  const char* name;
  std::string (*bytes)();
  Reader read;
};

void PrintTo(const PartSample& sample, std::ostream* out) {
  *out << sample.name;
}

ImportedPoints readSample(const PartSample& sample, const std::string& bytes,
                          const ReadOptions& options) {
  std::istringstream in(bytes);
  return sample.read(in, "sample", options, {});
}

/// Colors and intensities that are 0 everywhere count as none.
void expectSamePoints(RawPoints found, RawPoints expected) {
  dropEmptyColumns(found);
  dropEmptyColumns(expected);
  EXPECT_EQ(found.positions, expected.positions);
  EXPECT_EQ(found.colors, expected.colors);
  EXPECT_EQ(found.intensities, expected.intensities);
  EXPECT_EQ(found.stationOf, expected.stationOf);
  EXPECT_EQ(found.stations, expected.stations);
}

const Eigen::AlignedBox3d corner{Eigen::Vector3d(94, 194, 294), Eigen::Vector3d(100, 199, 301)};

class PartsOfScans : public testing::TestWithParam<PartSample> {};

TEST_P(PartsOfScans, AreThoseOfTheWholeScan) {
  const std::string bytes = GetParam().bytes();
  const RawPoints whole = readSample(GetParam(), bytes, {}).value;
  const std::size_t all = whole.positions.size();
  ASSERT_GE(all, 3600U);
  for (const ReadOptions& options :
       {ReadOptions{.most = 1}, ReadOptions{.most = 100}, ReadOptions{.most = 3000},
        ReadOptions{.most = 100'000}, ReadOptions{.box = corner},
        ReadOptions{.most = 50, .box = corner}}) {
    const ImportedPoints part = readSample(GetParam(), bytes, options);
    EXPECT_EQ(part.listed, all);
    expectSamePoints(part.value, partOf(whole, options));
    if (!options.box) {
      EXPECT_EQ(part.value.positions.size(), std::min<std::size_t>(options.most, all));
    }
  }
}

TEST_P(PartsOfScans, HaveAllThatLiesInTheBox) {
  const std::string bytes = GetParam().bytes();
  std::vector<Eigen::Vector3d> expected = readSample(GetParam(), bytes, {}).value.positions;
  std::erase_if(expected, [](const Eigen::Vector3d& place) { return !corner.contains(place); });
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(readSample(GetParam(), bytes, {.box = corner}).value.positions, expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, PartsOfScans,
    testing::Values(PartSample{"las", [] { return sampleLas(3); }, readLas},
                    PartSample{"laz", [] { return test::lazFile(sampleLas(3)); }, readLaz},
                    PartSample{"layered_laz", [] { return test::lazFile(sampleLas(7)); }, readLaz},
                    PartSample{"ply", [] { return written(writePly); }, readPly},
                    PartSample{"ascii_ply", sampleAsciiPly, readPly},
                    PartSample{"pcd", sampleBinaryPcd, readPcd},
                    PartSample{"ascii_pcd", sampleAsciiPcd, readPcd},
                    PartSample{"xyz", [] { return written(writeXyz); }, readXyz},
                    PartSample{"ptx", samplePtx, readPtx}, PartSample{"e57", sampleE57, readE57}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(PartsOfLaz, AreTheSameOnAnyNumberOfThreads) {
  const PartSample sample{"laz", nullptr, readLaz};
  const std::string bytes = test::lazFile(sampleLas(3));
  const ReadOptions options{.most = 321};
  const RawPoints many = readSample(sample, bytes, options).value;
  const ThreadLimit one(1);
  expectSamePoints(readSample(sample, bytes, options).value, many);
}

TEST(PartChooser, ALargerPartHoldsAllOfASmallerOne) {
  RawPoints line;
  for (int i = 0; i < 1000; ++i)
    line.positions.emplace_back(i, 0, 0);
  const auto chosen = [&](std::uint64_t most) {
    std::set<double> places;
    for (const Eigen::Vector3d& position : partOf(line, {.most = most}).positions)
      places.insert(position.x());
    return places;
  };
  const std::set<double> few = chosen(100);
  EXPECT_EQ(few.size(), 100U);
  EXPECT_TRUE(std::ranges::includes(chosen(300), few));
}

// Of 1000 places in a row each tenth of the file holds about a tenth of 200 chosen: 20, and 12 more
// or fewer would be three standard deviations.
TEST(PartChooser, TakesFromAllPartsOfAFileAlike) {
  RawPoints line;
  for (int i = 0; i < 1000; ++i)
    line.positions.emplace_back(i, 0, 0);
  std::array<int, 10> tenths{};
  for (const Eigen::Vector3d& position : partOf(line, {.most = 200}).positions)
    ++tenths[static_cast<std::size_t>(position.x() / 100)];
  for (const int tenth : tenths)
    EXPECT_NEAR(tenth, 20, 12);
}

TEST(PartChooser, NeverChoosesPointsWithoutAPlace) {
  RawPoints points;
  for (int i = 0; i < 100; ++i)
    points.positions.emplace_back(i % 2 == 0 ? 1.0 * i : std::nan(""), 0, 0);
  const RawPoints part = partOf(points, {.most = 50});
  ASSERT_EQ(part.positions.size(), 50U);
  for (const Eigen::Vector3d& position : part.positions)
    EXPECT_TRUE(position.allFinite());
}

// Colors of 16 bits that are all dark where the box is are still taken for 16 bits.
TEST(PartsOfLas, HaveTheColorsOfTheWhole) {
  std::string las = sampleLas(3);
  const LasHeader header = readLasHeader(las, "sample");
  for (int i = 0; i < pointsOfSample; ++i)
    for (int channel = 0; channel < 3; ++channel)
      setValueAt(las.data() + header.pointStart + header.pointLength * std::size_t(i) +
                     header.colorStart() + std::size_t(2 * channel),
                 static_cast<std::uint16_t>(corner.contains(samplePlace(i)) ? 200 : 60'000));
  std::istringstream in(las);
  const RawPoints part = readLas(in, "sample", {.box = corner}).value;
  EXPECT_TRUE(part.colors.empty()); // 200 of 65535 is black
}

/// Chunks of 50 points of the sample: the first over all, then one for each octant, then two for
/// octants of the octant at the low corner.
struct CopcSample {
  std::vector<int> order; // of the points of the sample
  test::CopcOctree octree;
};

std::string sampleCopc() {
  const Eigen::Vector3d center(100, 200, 300);
  CopcSample sample{.octree = {.center = center, .halfSide = 5}};
  std::vector<bool> isTaken(pointsOfSample);
  const auto addChunk = [&](const std::array<int, 4>& cell) {
    const double side = std::ldexp(10, -cell[0]);
    const Eigen::Vector3d least =
        center - Eigen::Vector3d::Constant(5) + side * Eigen::Vector3d(cell[1], cell[2], cell[3]);
    const Eigen::AlignedBox3d cube(least, least + Eigen::Vector3d::Constant(side));
    int added = 0;
    for (int i = 0; i < pointsOfSample && added < 50; ++i) {
      if (isTaken[std::size_t(i)] || !cube.contains(samplePlace(i))) continue;
      isTaken[std::size_t(i)] = true;
      sample.order.push_back(i);
      ++added;
    }
    EXPECT_EQ(added, 50);
    sample.octree.cells.push_back(cell);
  };
  addChunk({2, 0, 0, 0}); // writers need not begin with the coarsest
  addChunk({0, 0, 0, 0});
  for (int octant = 0; octant < 8; ++octant)
    addChunk({1, octant & 1, octant >> 1 & 1, octant >> 2});
  addChunk({2, 1, 0, 1});
  const auto points = static_cast<int>(sample.order.size());
  std::string las = lasAboutZero(7, points);
  const LasHeader header = readLasHeader(las, "sample");
  for (int i = 0; i < points; ++i)
    putPlace(las, header, i, samplePlace(sample.order[std::size_t(i)]));
  return test::copcFile(test::lazFile(las), sample.octree);
}

RawPoints readCopc(const std::string& bytes, const ReadOptions& options) {
  std::istringstream in(bytes);
  return readLaz(in, "tree.copc.laz", options).value;
}

std::vector<Eigen::Vector3d> sortedPlaces(std::vector<Eigen::Vector3d> places) {
  std::ranges::sort(places, [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::ranges::lexicographical_compare(a, b);
  });
  return places;
}

TEST(PartsOfCopc, AreWholeLevelsTheCoarsestFirst) {
  const std::string bytes = sampleCopc();
  const auto whole = readCopc(bytes, {}).positions;
  ASSERT_EQ(whole.size(), 550U);
  const auto chunks = [&](std::size_t first, std::size_t count) {
    const auto begin = whole.begin() + static_cast<std::ptrdiff_t>(50 * first);
    return std::vector(begin, begin + static_cast<std::ptrdiff_t>(50 * count));
  };
  EXPECT_EQ(readCopc(bytes, {.most = 50}).positions, chunks(1, 1));
  EXPECT_EQ(readCopc(bytes, {.most = 450}).positions, chunks(1, 9));
  // Of the level that is too many, as many as are left, and all of those before it.
  const auto some = readCopc(bytes, {.most = 100}).positions;
  ASSERT_EQ(some.size(), 100U);
  EXPECT_EQ(std::vector(some.begin(), some.begin() + 50), chunks(1, 1));
  EXPECT_EQ(sortedPlaces(readCopc(bytes, {.most = 1000}).positions), sortedPlaces(whole));
}

TEST(PartsOfCopc, HaveAllThatLiesInTheBox) {
  const std::string bytes = sampleCopc();
  for (const Eigen::Vector3d& reach : {Eigen::Vector3d(2, 2, 2), Eigen::Vector3d(6, 3, 9)}) {
    const Eigen::Vector3d least = Eigen::Vector3d(95, 195, 295);
    const Eigen::AlignedBox3d box(least, least + reach);
    std::vector<Eigen::Vector3d> expected = readCopc(bytes, {}).positions;
    std::erase_if(expected, [&](const Eigen::Vector3d& place) { return !box.contains(place); });
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(sortedPlaces(readCopc(bytes, {.box = box}).positions), sortedPlaces(expected));
  }
}

// What is not needed is not unpacked: damage there does not matter.
TEST(PartsOfCopc, DoNotUnpackCellsOutsideOfTheBox) {
  std::string bytes = sampleCopc();
  std::istringstream in(bytes);
  ByteSource source(in);
  const LasHeader header = readLasHeader(bytes, "sample");
  const LazChunk last = readLazLayout(source, header, "sample").chunks[9]; // the octant high in all
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(last.start + header.pointLength),
              last.size - header.pointLength, '\0');
  EXPECT_THROW((void)readCopc(bytes, {}), Error);
  const Eigen::Vector3d least(95, 195, 295);
  EXPECT_EQ(
      readCopc(bytes, {.box = Eigen::AlignedBox3d(least, least.array() + 4.9)}).positions.empty(),
      false);
  EXPECT_EQ(readCopc(bytes, {.most = 50}).positions.size(), 50U);
}

TEST(PartsOfCopc, AreRefusedWhereTheOctreeDoesNotFit) {
  const std::string bytes = sampleCopc();
  const std::size_t record = bytes.find("copc");
  ASSERT_NE(record, std::string::npos);
  const auto refusalWith = [&](std::uint64_t pageStart, std::uint64_t pageSize) {
    std::string bad = bytes;
    setValueAt(bad.data() + record - 2 + 54 + 40, pageStart);
    setValueAt(bad.data() + record - 2 + 54 + 48, pageSize);
    EXPECT_EQ(readCopc(bad, {}).positions.size(), 550U); // whole, it needs no octree
    return test::errorOf([&] { return readCopc(bad, {.most = 10}); });
  };
  const std::string refusal =
      "tree.copc.laz: its octree (COPC) does not fit its points, so no part "
      "of them is found: the file is damaged, copy or export it again";
  EXPECT_EQ(refusalWith(~0ULL, 32), refusal);
  EXPECT_EQ(refusalWith(0, ~0ULL), refusal);
  EXPECT_EQ(refusalWith(bytes.size() - 32, 32), refusal);
  EXPECT_EQ(refusalWith(0, 0), refusal);
}

TEST(PartsOfCopcOfOthers, AreLevelsOfTheOctree) {
  ESPALIER_SHARED_FILE(path, "laz/lone-star.copc.laz");
  std::ifstream in(path, std::ios::binary);
  const RawPoints whole = readLaz(in, "tree.laz").value;
  const Eigen::Vector3d some = whole.positions[1000];
  const Eigen::AlignedBox3d box(some.array() - 0.5, some.array() + 0.5);
  std::vector<Eigen::Vector3d> expected = whole.positions;
  std::erase_if(expected, [&](const Eigen::Vector3d& place) { return !box.contains(place); });
  EXPECT_EQ(sortedPlaces(readLaz(in, "tree.laz", {.box = box}).value.positions),
            sortedPlaces(expected));
  EXPECT_EQ(readLaz(in, "tree.laz", {.most = 20'000}).value.positions.size(), 20'000U);
}

} // namespace
} // namespace espalier
