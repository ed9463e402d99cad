#include "core/base/error.h"
#include "core/evaluate/match/path_length_agreement.h"
#include "core/evaluate/registration/registration.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <stop_token>

namespace espalier {
namespace {

const PathLengthOptions nearby{.distance = 0.3, .step = 0.1};

TEST(PathLengthAgreement, OfAPlantWithItselfIsPerfect) {
  for (const Skeleton& plant : {test::bush(), test::fork(3)}) {
    const auto agreed = pathLengthAgreement(plant, plant, nearby);
    EXPECT_GT(agreed.pairs, 1000U);
    EXPECT_EQ(agreed.connected, agreed.pairs);
    EXPECT_NEAR(agreed.meanError, 0, 1e-9);
    EXPECT_EQ(agreed.withinTenth, 1);
  }
}

// Two posts that are joined at the foot in truth, and at the top in the result. All is covered, and
// only paths that stay on one post are as long.
TEST(PathLengthAgreement, SeesWhereTheConnectionIsWrong) {
  const auto posts = [](bool isJoinedAtTop) {
    Skeleton plant = test::stick(5);
    std::vector<NodeId> post;
    for (int z = 0; z <= 4; ++z)
      post.push_back(plant.add({.position = {1, 0, static_cast<double>(z)},
                                .parent = z == 0 ? NodeId{0} : post.back(),
                                .edge = z == 0 ? EdgeType::branching : EdgeType::successor}));
    if (!isJoinedAtTop) return plant;
    Skeleton other = test::stick(5);
    NodeId last{4};
    for (int z = 4; z >= 0; --z)
      last = other.add({.position = {1, 0, static_cast<double>(z)}, .parent = last});
    return other;
  };
  const auto agreed = pathLengthAgreement(posts(true), posts(false), nearby);
  EXPECT_GT(agreed.found, agreed.pairs * 8 / 10); // all but 0.4 of 9, amid the rung, is there
  EXPECT_EQ(agreed.connected, agreed.found);
  EXPECT_LT(agreed.withinTenth, 0.65); // about half of the pairs are on one post
  EXPECT_GT(agreed.withinTenth, 0.35);
  EXPECT_GT(agreed.meanError, 0.1);
}

TEST(PathLengthAgreement, CountsPathsThatABrokenEdgeCuts) {
  Skeleton broken = test::stick(5);
  broken.makeRoot(NodeId{3}); // the edge from 2 to 3 is gone
  const auto agreed = pathLengthAgreement(broken, test::stick(5), {.distance = 0.6, .step = 0.1});
  EXPECT_EQ(agreed.found, agreed.pairs) << "the gap is nearby its ends";
  EXPECT_LT(agreed.connected, agreed.pairs * 7 / 10);
  EXPECT_GT(agreed.connected, agreed.pairs * 3 / 10);
  EXPECT_LE(agreed.withinTenth,
            static_cast<double>(agreed.connected) / static_cast<double>(agreed.pairs));
}

TEST(PathLengthAgreement, OfDisjointPlantsFindsNothing) {
  const auto agreed =
      pathLengthAgreement(test::shifted(test::bush(), {500, 0, 0}), test::bush(), nearby);
  EXPECT_EQ(agreed.found, 0U);
  EXPECT_EQ(agreed.withinTenth, 0);
}

TEST(PathLengthAgreement, DependsNeitherOnNodesWithinEdgesNorOnTheFrame) {
  const Skeleton reference = test::bush();
  const Skeleton result = test::jittered(reference, 0.03);
  const auto agreed = pathLengthAgreement(result, reference, nearby);
  const auto fine =
      pathLengthAgreement(test::withMiddleNodes(result), test::withMiddleNodes(reference), nearby);
  EXPECT_EQ(fine.found, agreed.found);
  EXPECT_NEAR(fine.meanError, agreed.meanError, 1e-6);
  const auto motion = test::motion(0.7, {3, 4, 5});
  const auto there = pathLengthAgreement(moved(result, motion), moved(reference, motion), nearby);
  EXPECT_EQ(there.found, agreed.found);
  EXPECT_NEAR(there.meanError, agreed.meanError, 1e-6);
}

TEST(PathLengthAgreement, DrawsByTheSeed) {
  const Skeleton reference = test::bush();
  const Skeleton result = test::jittered(reference, 0.03);
  const auto draw = [&](std::uint64_t seed) {
    return pathLengthAgreement(result, reference, {.distance = 0.3, .step = 0.1, .seed = seed})
        .meanError;
  };
  EXPECT_EQ(draw(1), draw(1));
  EXPECT_NE(draw(1), draw(2));
}

TEST(PathLengthAgreement, RefusesNothingAndStopsWhenAsked) {
  EXPECT_THROW((void)pathLengthAgreement({}, test::fork(2), nearby), Error);
  EXPECT_THROW((void)pathLengthAgreement(test::fork(2), {}, nearby), Error);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)pathLengthAgreement(test::fork(2), test::fork(2), nearby,
                                         Progress(source.get_token(), {})),
               Cancelled);
}

} // namespace
} // namespace espalier
