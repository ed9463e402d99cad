#include "app/window/files/load_files.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

QString writeScan(const std::filesystem::path& path) {
  std::ofstream out(path);
  for (int i = 0; i < 20; ++i)
    out << 0.1 * i << " 0 " << i << '\n';
  return QString::fromStdString(path.string());
}

TEST(LoadFiles, TakesAScanAndASkeletonTogether) {
  const std::filesystem::path folder = test::freshFolder();
  writeStructure(folder / "plant.mtg", test::fork(3));
  const LoadedFiles loaded = loadFiles(
      {QString::fromStdString((folder / "plant.mtg").string()), writeScan(folder / "plant.xyz")});
  ASSERT_NE(loaded.scan, nullptr);
  EXPECT_EQ(loaded.scan->cloud()->size(), 20);
  EXPECT_EQ(loaded.structure.value().skeleton.size(), 5U);
  EXPECT_TRUE(loaded.scanPath.endsWith("plant.xyz"));
}

TEST(LoadFiles, RefusesTwoScans) {
  const std::filesystem::path folder = test::freshFolder();
  const QStringList paths = {writeScan(folder / "a.xyz"), writeScan(folder / "b.xyz")};
  EXPECT_THAT([&] { (void)loadFiles(paths); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("b.xyz: one scan too many")));
}

TEST(LoadFiles, StopsWhenAsked) {
  const std::filesystem::path folder = test::freshFolder();
  std::stop_source stop;
  stop.request_stop();
  const Progress progress(stop.get_token(), {});
  EXPECT_THROW((void)loadFiles({writeScan(folder / "a.xyz")}, {}, progress), Cancelled);
}

TEST(LoadFiles, TakesTheUnitThatTheFileStatesOrThatOfItsCoordinates) {
  const std::filesystem::path folder = test::freshFolder();
  std::ofstream(folder / "map.xyz") << "500001 4000002 100\n501000 4001000 130\n";
  const auto unitOf = [&](const char* name) {
    return loadFiles({QString::fromStdString((folder / name).string())}).unit;
  };
  EXPECT_EQ(unitOf("map.xyz"), LengthUnit::meter) << "1 km of a forest, no plant in mm";
  std::ofstream(folder / "tall.xyz") << "0 0 0\n0 2 46.2\n";
  EXPECT_EQ(unitOf("tall.xyz"), LengthUnit::unknown) << "a tree, or a seedling in mm";
  std::ofstream(folder / "tall.ptx") << "1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n"
                                        "0 0 1 0\n0 0 0 1\n1 2 46.2 0.5\n";
  EXPECT_EQ(unitOf("tall.ptx"), LengthUnit::meter) << "as its format says";
}

TEST(LikelyUnit, MakesNoTreeAHundredMetersHigh) {
  const auto unitOf = [](double height) {
    return likelyUnit({Eigen::Vector3d::Zero(), Eigen::Vector3d(0, 0, height)});
  };
  EXPECT_EQ(unitOf(3820), LengthUnit::millimeter);
  EXPECT_EQ(unitOf(3.82), LengthUnit::meter);
  EXPECT_EQ(unitOf(0.01), LengthUnit::unknown);
}

} // namespace
} // namespace espalier
