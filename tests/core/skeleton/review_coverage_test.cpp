#include "core/skeleton/review_coverage.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(ReviewCoverage, CountsTheEdgeOfEachNode) {
  Skeleton plant = test::stick(5, 2); // four edges of 2
  plant.setReview(NodeId{1}, {.state = ReviewState::reviewed});
  plant.setReview(NodeId{2}, {.state = ReviewState::reviewed});
  plant.setReview(NodeId{3}, {.state = ReviewState::doubtful});
  const ReviewCoverage seen = coverage(plant);
  EXPECT_EQ(seen.length, (std::array{2.0, 2.0, 4.0}));
  EXPECT_EQ(seen.nodes, (std::array<std::size_t, 3>{2, 1, 2})) << "the root is to do, too";
  EXPECT_DOUBLE_EQ(seen.share(ReviewState::reviewed), 0.5);
  EXPECT_EQ(seen.state(), ReviewState::doubtful);
  EXPECT_FALSE(seen.isComplete());
}

TEST(ReviewCoverage, OfAnAxisIsOfItsNodesAlone) {
  Skeleton plant = test::fork(3);
  plant.setReview(NodeId{4}, {.state = ReviewState::reviewed});
  const ReviewCoverage shoot = coverage(plant, {NodeId{4}});
  EXPECT_TRUE(shoot.isComplete());
  EXPECT_EQ(shoot.state(), ReviewState::reviewed);
  EXPECT_DOUBLE_EQ(shoot.totalLength(), std::sqrt(2.0));
  EXPECT_EQ(coverage(plant, {NodeId{3}}).state(), ReviewState::toDo);
}

TEST(ReviewCoverage, IsCompleteOnlyWhenEveryNodeIsReviewed) {
  Skeleton plant = test::fork(3);
  for (const NodeId id : plant.ids())
    plant.setReview(id, {.state = ReviewState::reviewed});
  EXPECT_TRUE(coverage(plant).isComplete());
  plant.setReview(test::forkRoot, {}); // which has no edge, so no length is missing
  EXPECT_FALSE(coverage(plant).isComplete());
  EXPECT_DOUBLE_EQ(coverage(plant).share(ReviewState::reviewed), 1);
}

TEST(ReviewCoverage, OfNothingAndOfNoLengthIsNotComplete) {
  EXPECT_FALSE(coverage(Skeleton()).isComplete());
  EXPECT_EQ(coverage(Skeleton()).share(ReviewState::toDo), 0);
  Skeleton point = test::stick(1);
  EXPECT_EQ(coverage(point).share(ReviewState::toDo), 1) << "by nodes, as there is no length";
  point.setReview(NodeId{0}, {.state = ReviewState::reviewed});
  EXPECT_EQ(coverage(point).share(ReviewState::reviewed), 1);
}

} // namespace
} // namespace espalier
