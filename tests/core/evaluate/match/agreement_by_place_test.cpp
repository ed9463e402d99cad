#include "core/evaluate/match/agreement_by_place.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr double nearPlace = 0.01;
constexpr double step = 0.001;

/// A trunk from z = 0 to 10, with a branch of 3 at half its height.
Skeleton tree(bool hasBranch, double height = 10) {
  Skeleton skeleton;
  const NodeId root = skeleton.add({.position = {0, 0, 0}});
  const NodeId middle = skeleton.add({.position = {0, 0, 5}, .parent = root});
  skeleton.add({.position = {0, 0, height}, .parent = middle});
  if (hasBranch)
    skeleton.add({.position = {3, 0, 5}, .parent = middle, .edge = EdgeType::branching});
  return skeleton;
}

TEST(AgreementByPlace, OfAPlantWithItselfIsWhole) {
  const AgreementByPlace agreed = agreementByPlace(tree(true), tree(true), nearPlace, step);
  ASSERT_EQ(agreed.byOrder.size(), 2U);
  ASSERT_EQ(agreed.byHeight.size(), 10U);
  for (const auto& parts : {agreed.byOrder, agreed.byHeight})
    for (const PartAgreement& part : parts) {
      EXPECT_EQ(part.precision, 1);
      EXPECT_EQ(part.recall, 1);
    }
  EXPECT_NEAR(agreed.byOrder[0].resultLength, 10, 0.01);
  EXPECT_NEAR(agreed.byOrder[1].referenceLength, 3, 0.01);
}

TEST(AgreementByPlace, AMissingBranchLowersTheRecallOfItsOrder) {
  const AgreementByPlace agreed = agreementByPlace(tree(false), tree(true), nearPlace, step);
  EXPECT_EQ(agreed.byOrder[0].recall, 1);
  EXPECT_NEAR(agreed.byOrder[1].recall, nearPlace / 3, 1e-3) << "but where it leaves the trunk";
  EXPECT_EQ(agreed.byOrder[1].precision, 1) << "nothing is invented";
  EXPECT_EQ(agreed.byOrder[1].resultLength, 0);
  const AgreementByPlace back = agreementByPlace(tree(true), tree(false), nearPlace, step);
  EXPECT_NEAR(back.byOrder[1].precision, nearPlace / 3, 1e-3);
  EXPECT_EQ(back.byOrder[1].recall, 1);
}

TEST(AgreementByPlace, AMissingTopLowersTheRecallOfTheHighestLayers) {
  const AgreementByPlace agreed = agreementByPlace(tree(false, 8), tree(false), nearPlace, step);
  for (std::size_t layer = 0; layer < 8; ++layer)
    EXPECT_EQ(agreed.byHeight[layer].recall, 1) << layer;
  EXPECT_NEAR(agreed.byHeight[8].recall, nearPlace, 1e-3);
  EXPECT_EQ(agreed.byHeight[9].recall, 0);
  EXPECT_NEAR(agreed.byHeight[9].from, 9, 0.01);
  EXPECT_NEAR(agreed.byHeight[9].to, 10, 0.01);
  EXPECT_EQ(agreed.byHeight[9].precision, 1);
}

TEST(AgreementByPlace, OfAFlatPlantIsOneLayer) {
  Skeleton flat;
  flat.add({.position = {0, 0, 1}});
  flat.add({.position = {1, 0, 1}, .parent = NodeId{0}});
  const AgreementByPlace agreed = agreementByPlace(flat, flat, nearPlace, step);
  EXPECT_NEAR(agreed.byHeight[0].resultLength, 1, 1e-9);
  EXPECT_EQ(agreed.byHeight[9].resultLength, 0);
}

TEST(AgreementByPlace, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)agreementByPlace(tree(true), tree(true), nearPlace, step, progress);
  }));
}

} // namespace
} // namespace espalier
