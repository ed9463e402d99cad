#include "core/pipeline/kind_of_scan.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/leafy_plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

std::shared_ptr<const PointCloud> scanOfKind(Architecture architecture, int segments,
                                             const Foliage& foliage, std::uint64_t seed,
                                             Eigen::Index points = 30'000) {
  return std::make_shared<const PointCloud>(
      test::labeledScanOf(
          growPlant({.architecture = architecture, .height = 4, .segments = segments}, seed),
          foliage, points)
          .cloud);
}

Foliage strapsOfKind() {
  Foliage foliage{
      .blades = {.spacing = 0.12, .length = 0.5, .width = 0.05, .angle = 0.6, .reach = 10}};
  foliage.droop = 1.2;
  return foliage;
}

std::shared_ptr<const PointCloud> herbOfKind() {
  return std::make_shared<const PointCloud>(test::leafyHerb().cloud);
}

// Of seeds that nothing was fitted on.
TEST(KindOfScan, TellsPlantsApart) {
  const auto kindOf = [](const std::shared_ptr<const PointCloud>& cloud) {
    return kindOfScan(cloud).value().likely.kind;
  };
  EXPECT_EQ(kindOf(scanOfKind(Architecture::broadleaf, 150, {}, 90'011)), PlantKind::bareTree);
  EXPECT_EQ(
      kindOf(scanOfKind(Architecture::conifer, 150, foliageOf(Architecture::conifer, 3), 90'012)),
      PlantKind::needleTree);
  Foliage leaves{.blades = {.spacing = 0.006, .length = 0.04, .width = 0.024, .reach = 0.2}};
  leaves.petiole = 0.3;
  EXPECT_EQ(kindOf(scanOfKind(Architecture::broadleaf, 150, leaves, 90'013)), PlantKind::leafyTree);
  EXPECT_EQ(kindOf(herbOfKind()), PlantKind::herb);
  EXPECT_EQ(kindOf(scanOfKind(Architecture::herb, 1, strapsOfKind(), 90'014)), PlantKind::grass);
}

TEST(KindOfScan, IsTheSameHoweverThePlantStandsAndWhateverItsUnit) {
  const std::optional<KindOfScan> kind = kindOfScan(herbOfKind());
  RawPoints lying;
  for (Eigen::Index i = 0; i < herbOfKind()->size(); ++i) {
    const Eigen::Vector3d place = herbOfKind()->position(i);
    lying.positions.push_back(1000 * Eigen::Vector3d(place.y(), place.z(), place.x()));
  }
  const std::optional<KindOfScan> turned = kindOfScan(
      std::make_shared<const PointCloud>(std::move(lying)), PipelineOptions{.up = UpAxis::y});
  EXPECT_EQ(turned->likely.kind, kind->likely.kind);
  EXPECT_NEAR(turned->likely.probability, kind->likely.probability, 0.05);
}

TEST(KindOfScan, IsATreeIfItIsAsTall) {
  const double height = herbOfKind()->bounds().sizes().z();
  EXPECT_EQ(kindOfScan(herbOfKind(), {}, 0.5 / height)->likely.kind, PlantKind::herb);
  const PlantKind tall = kindOfScan(herbOfKind(), {}, 40 / height)->likely.kind;
  EXPECT_NE(tall, PlantKind::herb);
  EXPECT_NE(tall, PlantKind::grass);
}

TEST(KindOfScan, OfAForestIsNone) {
  const Eigen::Vector3d sizes = herbOfKind()->bounds().sizes();
  const double width = sizes.head<2>().maxCoeff();
  EXPECT_TRUE(kindOfScan(herbOfKind(), {}, 90 / width));
  EXPECT_FALSE(kindOfScan(herbOfKind(), {}, 110 / width));
}

TEST(KindOfScan, DoesNotCountWhatIsSetAside) {
  const test::LabeledCloud& scan = test::leafyHerb();
  std::vector<Eigen::Index> blades;
  for (std::size_t i = 0; i < scan.organs.size(); ++i)
    if (scan.organs[i] == Organ::blade) blades.push_back(static_cast<Eigen::Index>(i));
  const double before = kindOfScan(herbOfKind())->shares[2];
  const double after =
      kindOfScan(herbOfKind(), PipelineOptions{.leftOut = PointSet::of(blades)})->shares[2];
  EXPECT_GT(before, 0.6);
  EXPECT_LT(after, 0.3 * before);
}

TEST(KindOfScan, OfALargeScanFollowsFromSomeOfItsPoints) {
  const auto cloud = scanOfKind(Architecture::herb, 1, strapsOfKind(), 90'014, 115'000);
  ASSERT_GT(cloud->size(), 100'000);
  const std::optional<KindOfScan> kind = kindOfScan(cloud);
  ASSERT_TRUE(kind);
  EXPECT_EQ(kind->likely.kind, PlantKind::grass);
  EXPECT_EQ(kind, kindOfScan(cloud));
}

TEST(KindOfScan, IsNotKnownOfFewPointsOrOfOnePlace) {
  RawPoints few;
  for (int i = 0; i < 150; ++i)
    few.positions.emplace_back(i, 0, 0);
  EXPECT_FALSE(kindOfScan(std::make_shared<const PointCloud>(std::move(few))));
  RawPoints same;
  same.positions.assign(5000, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(kindOfScan(std::make_shared<const PointCloud>(std::move(same))));
  EXPECT_FALSE(kindOfScan(std::make_shared<const PointCloud>()));
}

TEST(KindOfScan, IsStopped) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)kindOfScan(herbOfKind(), {}, 0, Progress(stop.get_token(), {})), Cancelled);
}

TEST(KindOfScan, HasSettingsForEachKind) {
  for (const PlantKind kind : allPlantKinds)
    EXPECT_EQ(presetFor(kind).kind, kind);
}

} // namespace
} // namespace espalier
