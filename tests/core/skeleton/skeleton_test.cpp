#include "core/base/error.h"
#include "core/skeleton/skeleton.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::forkRoot;
using test::forkTop;
using testing::ElementsAre;

TEST(Skeleton, ListsParentsBeforeTheirChildren) {
  Skeleton plant = test::fork(3);
  plant.add({.parent = NodeId{4}});
  plant.reparent(NodeId{2}, NodeId{5}, EdgeType::branching);
  EXPECT_THAT(plant.ids(),
              ElementsAre(NodeId{0}, NodeId{1}, NodeId{3}, NodeId{4}, NodeId{5}, NodeId{2}));
}

TEST(Skeleton, ListsTheSuccessorFirst) {
  Skeleton plant = test::fork(3);
  plant.setEdge(NodeId{2}, EdgeType::branching);
  plant.setEdge(NodeId{4}, EdgeType::successor);
  EXPECT_THAT(plant.children(forkTop), ElementsAre(NodeId{4}, NodeId{2}, NodeId{3}));
}

TEST(Skeleton, RefusesAMissingParent) {
  Skeleton plant = test::stick(2);
  EXPECT_THROW(plant.add({.parent = NodeId{7}}), Error);
  EXPECT_EQ(plant, test::stick(2));
}

TEST(Skeleton, RefusesToAttachABranchToItself) {
  Skeleton plant = test::fork(2);
  EXPECT_THROW(plant.reparent(forkRoot, NodeId{2}, EdgeType::successor), Error);
  EXPECT_THROW(plant.reparent(forkTop, forkTop, EdgeType::successor), Error);
  EXPECT_EQ(plant, test::fork(2));
}

TEST(Skeleton, NeverHandsOutAnErasedIdAgain) {
  Skeleton plant = test::fork(2);
  plant.erase(NodeId{3});
  EXPECT_EQ(plant.add({.parent = forkTop}), NodeId{4});
  EXPECT_FALSE(plant.contains(NodeId{3}));
  EXPECT_EQ(plant.size(), 4U);
}

TEST(Skeleton, IsEqualToOneThatErasedANodeInBetween) {
  Skeleton plant = test::fork(2);
  plant.erase(plant.add({.parent = forkTop}));
  EXPECT_EQ(plant, test::fork(2));
}

TEST(Skeleton, CarriesABranchToItsNewParent) {
  Skeleton plant = test::stick(5);
  plant.reparent(NodeId{3}, NodeId{0}, EdgeType::branching);
  EXPECT_TRUE(plant.isAncestor(NodeId{3}, NodeId{4}));
  EXPECT_FALSE(plant.isAncestor(NodeId{1}, NodeId{4}));
  EXPECT_THAT(plant.children(forkRoot), ElementsAre(NodeId{1}, NodeId{3}));
}

TEST(Skeleton, AttachesABranchToASiblingOrToItsGrandparent) {
  Skeleton plant = test::fork(2);
  plant.reparent(NodeId{3}, NodeId{2}, EdgeType::successor);
  EXPECT_THAT(plant.children(NodeId{2}), ElementsAre(NodeId{3}));
  plant.reparent(NodeId{2}, forkRoot, EdgeType::branching);
  EXPECT_THAT(plant.children(forkRoot), ElementsAre(forkTop, NodeId{2}));
  EXPECT_THROW(plant.reparent(NodeId{2}, NodeId{3}, EdgeType::successor), Error) << "its child";
}

} // namespace
} // namespace espalier
