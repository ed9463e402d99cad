#include "core/evaluate/match/path_matches.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/core/evaluate/tab_structure.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <stop_token>

namespace espalier {
namespace {

using testing::ElementsAre;

/// A stick of 4 with a spur of 0.1 at this height: two segments and the spur.
Skeleton spurred(int height) {
  Skeleton plant = test::stick(5);
  plant.add({.position = {0.1, 0, static_cast<double>(height)},
             .parent = NodeId{static_cast<std::uint32_t>(height)},
             .edge = EdgeType::branching});
  return plant;
}

TEST(PathMatches, JoinAStickThatASpurCutsWhereverItIs) {
  for (const int height : {1, 2, 3}) {
    const auto paths = pathMatches(authorsComparison(spurred(height), test::stick(5)));
    ASSERT_EQ(paths.matches.size(), 1U) << height;
    EXPECT_THAT(paths.matches[0].result, ElementsAre(0, 1)) << height;
    EXPECT_THAT(paths.matches[0].reference, ElementsAre(0)) << height;
    EXPECT_EQ(paths.matches[0].cost, 0);
    EXPECT_EQ(paths.extended, 1U);
    EXPECT_NEAR(paths.cost, 0.1, 1e-12) << "the spur alone";
    EXPECT_NEAR(paths.geometric, 8 / 8.1, 1e-12);
    EXPECT_NEAR(paths.lengthPrecision, 4 / 4.1, 1e-12);
    EXPECT_EQ(paths.lengthRecall, 1);
  }
}

TEST(PathMatches, JoinTheReferenceLikewise) {
  const auto paths = pathMatches(authorsComparison(test::stick(5), spurred(2)));
  ASSERT_EQ(paths.matches.size(), 1U);
  EXPECT_THAT(paths.matches[0].result, ElementsAre(0));
  EXPECT_THAT(paths.matches[0].reference, ElementsAre(0, 1));
  EXPECT_NEAR(paths.geometric, 8 / 8.1, 1e-12);
  EXPECT_EQ(paths.lengthPrecision, 1);
}

TEST(PathMatches, JoinAcrossTwoSpurs) {
  Skeleton plant = spurred(1);
  plant.add({.position = {0.1, 0, 3}, .parent = NodeId{3}, .edge = EdgeType::branching});
  const auto paths = pathMatches(authorsComparison(plant, test::stick(5)));
  ASSERT_EQ(paths.matches.size(), 1U);
  EXPECT_EQ(paths.matches[0].result.size(), 3U);
  EXPECT_EQ(paths.matches[0].cost, 0);
}

TEST(PathMatches, OfAPlantWithItselfAreOneToOne) {
  const auto paths = pathMatches(authorsComparison(test::bush(), test::bush()));
  EXPECT_EQ(paths.extended, 0U);
  EXPECT_EQ(paths.cost, 0);
  EXPECT_EQ(paths.geometric, 1);
}

TEST(PathMatches, TakeEachSegmentOnceAndOnlyBetterTheMatch) {
  Skeleton result = test::jittered(test::bush(), 0.05);
  for (const std::uint32_t foot : {3U, 9U, 20U, 33U, 47U, 58U}) // spurs that cut segments in two
    result.add({.position = result[NodeId{foot}].position + Eigen::Vector3d(0.2, 0, 0),
                .parent = NodeId{foot},
                .edge = EdgeType::branching});
  const auto comparison = authorsComparison(result, test::bush());
  const auto paths = pathMatches(comparison);
  EXPECT_GT(paths.extended, 0U);
  EXPECT_LT(paths.cost, comparison.cost);
  EXPECT_GE(paths.geometric, comparison.geometric);
  std::vector<std::size_t> taken(comparison.resultSegments.size(), 0);
  for (std::size_t k = 0; k < paths.matches.size(); ++k) {
    const std::vector<std::size_t>& path = paths.matches[k].result;
    EXPECT_LE(paths.matches[k].cost, comparison.matches[k].cost);
    for (std::size_t i = 0; i < path.size(); ++i) {
      EXPECT_EQ(++taken[path[i]], 1U);
      if (i > 0) {
        EXPECT_EQ(comparison.resultSegments[path[i]].parent, path[i - 1]);
      }
    }
  }
}

// What the authors' automatic result has too many are spurs that cut its branches.
TEST(PathMatches, CoverMoreOfTheAuthorsAutomaticResult) {
  ESPALIER_SHARED_FILE(automatic, "puu1/thesis_automatic.mtg");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const auto comparison =
      authorsComparison(test::readTabStructure(automatic), test::readTabStructure(expert));
  const auto paths = pathMatches(comparison);
  EXPECT_EQ(paths.matches.size(), 1035U);
  EXPECT_GT(paths.lengthPrecision, comparison.lengthPrecision + 0.03);
  EXPECT_GE(paths.lengthRecall, comparison.lengthRecall);
}

TEST(PathMatches, StopWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const auto comparison = authorsComparison(test::fork(3), test::fork(3));
  EXPECT_THROW((void)pathMatches(comparison, Progress(source.get_token(), {})), Cancelled);
}

} // namespace
} // namespace espalier
