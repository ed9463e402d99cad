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

TEST(LikelyUnit, MakesNoTreeAHundredMetersHigh) {
  EXPECT_EQ(likelyUnit(3820), LengthUnit::millimeter);
  EXPECT_EQ(likelyUnit(3.82), LengthUnit::meter);
  EXPECT_EQ(likelyUnit(0.01), LengthUnit::unknown);
  EXPECT_EQ(likelyUnit(46.2), LengthUnit::unknown) << "a tree, or a seedling in mm";
}

} // namespace
} // namespace espalier
