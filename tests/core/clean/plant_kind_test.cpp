#include "core/clean/plant_kind.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

// Upright strips: two of wood side by side, and above them a third, of blades.
TEST(PlantKind, FollowsFromSharesPartsAndShapes) {
  Eigen::Matrix3Xf points(3, 300);
  std::vector<Organ> organs;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Index strip = i / 100;
    const auto row = static_cast<float>(i % 100) * 0.05F;
    points.col(i) << (strip == 1 ? 2.0F : 0.0F), (i % 2 == 0 ? 0.0F : 0.02F),
        strip == 2 ? row + 5 : row;
    organs.push_back(strip == 2 ? Organ::blade : Organ::wood);
  }
  const KindFeatures features = kindFeatures(points, organs, 0.05);
  EXPECT_NEAR(features[0], 2.0 / 3, 1e-9);
  EXPECT_NEAR(features[2], 1.0 / 3, 1e-9);
  EXPECT_EQ(features[1] + features[3], 0);
  EXPECT_NEAR(features[4], std::log(9.95 / 2), 0.03);
  EXPECT_NEAR(features[5], std::log(1 + 2), 1e-9) << "two strips below";
  EXPECT_NEAR(features[7], std::log(1 + 1), 1e-9) << "and one above";
  EXPECT_NEAR(features[8], std::log(4.95 / std::sqrt(12) / 9.95), 0.05) << "an even line";
  EXPECT_LT(features[9], 0.02) << "which is narrow";
  EXPECT_NEAR(features[10], std::log(1 + 1), 1e-9) << "one blade";
  EXPECT_NEAR(features[11], std::log(10 / 0.05), 0.01);
}

TEST(PlantKind, IsTheOneOfTheGreatestOdds) {
  KindOdds odds = {};
  for (std::size_t i = 0; i < odds.size(); ++i)
    odds[i].constant = -2;
  odds[3].constant = 1;
  const double herb = 1 / (1 + std::exp(-1.0));
  const double other = 1 / (1 + std::exp(2.0));
  const LikelyKind found = likelyKind({}, odds);
  EXPECT_EQ(found.kind, PlantKind::herb);
  EXPECT_NEAR(found.probability, 0.94 * herb / (herb + 4 * other) + 0.06 / 5, 1e-12);
}

TEST(PlantKind, IsNoHerbOfTheHeightOfATreeHoweverSureItsShapeIs) {
  KindOdds odds = {};
  for (std::size_t i = 0; i < odds.size(); ++i)
    odds[i].constant = -20;
  odds[3].constant = 20;  // a herb
  odds[2].constant = -19; // before the others a tree in leaf
  EXPECT_EQ(likelyKind({}, odds).kind, PlantKind::herb);
  EXPECT_NEAR(likelyKind({}, odds).probability, 0.952, 1e-6);
  EXPECT_EQ(likelyKind({}, odds, 0.5).kind, PlantKind::herb);
  EXPECT_NEAR(likelyKind({}, odds, 0.5).probability, 0.952, 1e-3);
  const LikelyKind tall = likelyKind({}, odds, 23);
  EXPECT_EQ(tall.kind, PlantKind::leafyTree);
  EXPECT_LT(tall.probability, 0.35) << "of a tree, but nobody knows of which";
}

TEST(PlantKind, OfOnePointIsFinite) {
  const KindFeatures features = kindFeatures(Eigen::Matrix3Xf::Zero(3, 1), {Organ::wood}, 1);
  for (const double feature : features)
    EXPECT_TRUE(std::isfinite(feature));
}

} // namespace
} // namespace espalier
