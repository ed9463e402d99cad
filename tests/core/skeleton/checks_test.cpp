#include "core/skeleton/checks.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = Finding::Kind;

TEST(Check, FindsNothingInASoundPlant) {
  EXPECT_THAT(check(test::fork(3)), IsEmpty());
  EXPECT_THAT(check({}), IsEmpty());
}

TEST(Check, FindsASecondSuccessor) {
  Skeleton plant = test::fork(3);
  plant.setEdge(NodeId{4}, EdgeType::successor);
  EXPECT_THAT(check(plant), ElementsAre(Finding{Kind::twoSuccessors, test::forkTop}));
  EXPECT_EQ(describe(check(plant).front(), plant),
            "node 1 has 2 successors: an axis continues once");
}

TEST(Check, FindsEdgesWithoutLength) {
  Skeleton plant = test::stick(3);
  plant.setPosition(NodeId{2}, plant[NodeId{1}].position);
  EXPECT_THAT(check(plant), ElementsAre(Finding{Kind::noLength, NodeId{2}}));
}

TEST(Check, FindsWoodThickerThanWhatCarriesIt) {
  Skeleton plant = test::stick(3);
  plant.setRadius(NodeId{2}, 0.2);
  EXPECT_THAT(check(plant), ElementsAre(Finding{Kind::radiusAboveParent, NodeId{2}}));
}

} // namespace
} // namespace espalier
