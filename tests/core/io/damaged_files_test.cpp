#include "core/base/error.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/plantgl/bgeom.h"
#include "core/io/plantgl/bmtg.h"
#include "core/io/plantgl/geom.h"
#include "core/io/points/e57.h"
#include "core/io/points/las.h"
#include "core/io/points/laz.h"
#include "core/io/points/pcd.h"
#include "core/io/points/ply.h"
#include "core/io/points/ptx.h"
#include "core/io/points/xyz.h"
#include "core/io/qsm/qsm_mat.h"
#include "core/io/qsm/qsm_table.h"
#include "core/io/structures/graphml.h"
#include "core/io/structures/node_list.h"
#include "core/io/structures/opf.h"
#include "core/io/structures/rsml.h"
#include "core/io/structures/swc.h"
#include "core/io/structures/treefile.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_skeleton.h"
#include "tests/core/io/plantgl/bgeom_writer.h"
#include "tests/core/io/plantgl/pickle_writer.h"
#include "tests/core/io/points/e57_writer.h"
#include "tests/core/io/points/laz_writer.h"
#include "tests/core/io/qsm/mat_writer.h"
#include "tests/core/io/qsm/qsm_samples.h"
#include "tests/core/io/samples.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>

namespace espalier {
namespace {

/// Damage of the kinds that files meet: lost, added, repeated and changed bytes, and numbers that
/// mean something else.
std::string damaged(std::string bytes, Random& random) {
  constexpr auto scraps = std::to_array<std::string_view>(
      {"-1", "1e999", "nan", "999999999999", "\n", "\t", "^", "<", "/", "+", "#",
       "\xff\xff\xff\xff", std::string_view("\0\0\0\0", 4), " ", ";", ",", "\x7f\xff\xff\xff"});
  const std::size_t wounds = 1 + random.below(4);
  for (std::size_t i = 0; i < wounds && !bytes.empty(); ++i) {
    const std::size_t at = random.below(bytes.size());
    const std::size_t length = 1 + random.below(std::min<std::size_t>(bytes.size() - at, 24));
    switch (random.below(6)) {
    case 0:
      bytes[at] = static_cast<char>(random.below(256));
      break;
    case 1:
      bytes.erase(at, length);
      break;
    case 2:
      bytes.resize(at);
      break;
    case 3:
      bytes.insert(at, bytes.substr(random.below(bytes.size()), length));
      break;
    case 4:
      bytes.insert(at, scraps[random.below(scraps.size())]);
      break;
    default: {
      const std::string_view scrap = scraps[random.below(scraps.size())];
      bytes.replace(at, std::min(scrap.size(), bytes.size() - at), scrap);
    }
    }
  }
  return bytes;
}

struct Reader {
  const char* name;
  std::string (*sample)();
  void (*read)(std::istream& in);
};

void PrintTo(const Reader& reader, std::ostream* out) {
  *out << reader.name;
}

template <auto read> void readCloud(std::istream& in) {
  const PointCloud cloud(read(in, "damaged", {}, {}).value);
  ASSERT_TRUE(cloud.positions().allFinite());
}

template <auto read> void readWhole(std::istream& in) {
  const PointCloud cloud(read(in, "damaged", {}).value);
  ASSERT_TRUE(cloud.positions().allFinite());
}

template <Imported<Skeleton> (*read)(std::istream&, const std::string&)>
void readSkeleton(std::istream& in) {
  const Skeleton skeleton = read(in, "damaged").value;
  for (const NodeId id : skeleton.ids())
    ASSERT_TRUE(skeleton[id].position.allFinite() && skeleton[id].radius >= 0);
}

class DamagedFiles : public testing::TestWithParam<Reader> {};

TEST_P(DamagedFiles, AreReadOrRefusedAndNothingElse) {
  const std::string sample = GetParam().sample();
  Random random(1);
  int refused = 0;
  constexpr int files = 3000;
  for (int i = 0; i < files; ++i) {
    const std::string bytes = damaged(sample, random);
    std::istringstream in(bytes);
    try {
      GetParam().read(in);
    } catch (const Error& error) {
      ++refused;
      ASSERT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
    }
  }
  EXPECT_GT(refused, files / 50) << "the damage does too little to test anything";
  EXPECT_LT(refused, files) << "the damage is found before anything is read";
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedFiles,
    testing::Values(
        Reader{"PLY", [] { return test::plyFile(std::endian::little); }, readCloud<readPly>},
        Reader{"PLY text", test::asciiPlyFile, readCloud<readPly>},
        Reader{"LAS 1.2", [] { return test::lasFile({.format = 3}); }, readCloud<readLas>},
        Reader{"LAS 1.4", [] { return test::lasFile({.minorVersion = 4, .format = 7}); },
               readCloud<readLas>},
        Reader{"LAZ 1.2", [] { return test::lazFile(test::lasFile({.format = 3, .points = 20})); },
               readCloud<readLaz>},
        Reader{"LAZ 1.4",
               [] {
                 return test::lazFile(test::lasFile({.minorVersion = 4, .format = 7, .points = 20}),
                                      {.chunkSize = 6, .hasChunksOfAnySize = true});
               },
               readCloud<readLaz>},
        Reader{"PCD", [] { return test::pcdFile(test::PcdKind::binary); }, readCloud<readPcd>},
        Reader{"PCD text", [] { return test::pcdFile(test::PcdKind::ascii); }, readCloud<readPcd>},
        Reader{"PCD compressed", [] { return test::pcdFile(test::PcdKind::compressed); },
               readCloud<readPcd>},
        Reader{"XYZ", test::xyzFile, readCloud<readXyz>},
        Reader{"PTX", test::ptxFile, readCloud<readPtx>},
        Reader{"E57 with checksums that fit", test::e57SampleFile,
               [](std::istream& in) {
                 std::istringstream healed(test::healedE57(readAll(in)));
                 readCloud<readE57>(healed);
               }},
        Reader{"MTG", test::mtgFile,
               [](std::istream& in) {
                 (void)skeletonOf(readMtg(in, "damaged").value, "damaged").value.ids();
               }},
        Reader{"node list", test::nodeListFile, readSkeleton<readNodeList>},
        Reader{"SWC", test::swcFile, readSkeleton<readSwc>},
        Reader{"treefile", test::treefileFile, readSkeleton<readTreefile>},
        Reader{"GraphML", test::graphmlFile, readSkeleton<readGraphml>},
        Reader{"OPF", test::opfFile,
               [](std::istream& in) {
                 (void)skeletonOf(readOpf(in, "damaged").value, "damaged").value.ids();
               }},
        Reader{"RSML", test::rsmlFile, readSkeleton<readRsml>},
        Reader{"BGEOM", test::bgeomFile, readWhole<readBgeom>},
        Reader{"GEOM", test::geomFile, readWhole<readGeom>},
        Reader{"BMTG", test::bmtgFile,
               [](std::istream& in) {
                 (void)skeletonOf(readBmtg(in, "damaged").value, "damaged").value.ids();
               }},
        Reader{"QSM table", test::treeQsmTable, readSkeleton<readQsmTable>},
        Reader{"QSM", test::qsmMatFile, readSkeleton<readQsmMat>}));

} // namespace
} // namespace espalier
