#include "app/window/review/doubt_ghosts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// A stem of three nodes, 0 to 2, with a branch of two, 3 and 4, on node 1.
Skeleton plantInDoubt() {
  Skeleton plant;
  std::optional<NodeId> last;
  for (int i = 0; i < 3; ++i)
    last = plant.add({.position = {0, 0, 1.0 * i}, .radius = 0.1, .parent = last});
  const NodeId low = plant.add(
      {.position = {1, 0, 1}, .radius = 0.1, .parent = NodeId(1), .edge = EdgeType::branching});
  plant.add({.position = {2, 0, 1}, .radius = 0.1, .parent = low});
  return plant;
}

Doubt attachmentInDoubt() {
  return {
      .kind = Doubt::Kind::attachment,
      .node = NodeId(3),
      .nodes = {NodeId(3), NodeId(4)},
      .alternatives = {{.kind = Alternative::Kind::attach, .probability = 0.6, .onto = NodeId(2)},
                       {.kind = Alternative::Kind::asItIs, .probability = 0.3},
                       {.kind = Alternative::Kind::remove, .probability = 0.1}},
      .present = 1};
}

TEST(DoubtGhosts, ShowWhereWoodWouldGrowFromAndWhereItDoes) {
  const std::vector<ShownGhost> ghosts = ghostsOf(plantInDoubt(), attachmentInDoubt());
  ASSERT_EQ(ghosts.size(), 3U);
  for (std::size_t i = 0; i < ghosts.size(); ++i)
    EXPECT_EQ(ghosts[i].number, static_cast<int>(i) + 1);
  EXPECT_EQ(ghosts[0].look, ShownGhost::Look::present) << "however improbable it is";
  const std::vector<Eigen::Vector3d> asItIs = {{0, 0, 1}, {1, 0, 1}};
  ASSERT_EQ(ghosts[0].lines.size(), 1U);
  EXPECT_EQ(ghosts[0].lines.front(), asItIs) << "the edge alone that would move";
  EXPECT_EQ(ghosts[1].look, ShownGhost::Look::proposed);
  const std::vector<Eigen::Vector3d> fromAbove = {{0, 0, 2}, {1, 0, 1}};
  ASSERT_EQ(ghosts[1].lines.size(), 1U);
  EXPECT_EQ(ghosts[1].lines.front(), fromAbove);
  EXPECT_EQ(ghosts[2].look, ShownGhost::Look::removed);
  EXPECT_EQ(ghosts[2].lines.front().back(), Eigen::Vector3d(2, 0, 1)) << "its cross is at the tip";
}

TEST(DoubtGhosts, LookAtTheFootOfWoodThatMayGrowElsewhere) {
  const Sight sight = sightOf(plantInDoubt(), attachmentInDoubt());
  EXPECT_EQ(sight.nodes, (std::vector{NodeId(3), NodeId(4)}));
  EXPECT_EQ(sight.apart.size(), 2U) << "where it may grow from, and where it does";
  for (const Eigen::Vector3d& place : sight.places)
    EXPECT_LE(place.x(), 1) << "not at all that would go";
}

TEST(DoubtGhosts, DrawABranchThatIsMissingAsOneLineForEachRun) {
  Doubt doubt{.kind = Doubt::Kind::missing, .node = NodeId(2)};
  GrownBranch branch{.on = NodeId(2), .part = {}};
  const NodeId root = branch.part.add({.position = {0, 0, 2}});
  NodeId last = root;
  for (int i = 1; i < 4; ++i)
    last = branch.part.add({.position = {0.1 * i, 0, 2}, .parent = last});
  branch.part.add({.position = {0.2, 0.1, 2}, .parent = NodeId(2), .edge = EdgeType::branching});
  doubt.alternatives = {{.kind = Alternative::Kind::asItIs, .probability = 0.1},
                        {.kind = Alternative::Kind::add, .probability = 0.9, .branch = branch}};
  std::swap(doubt.alternatives[0], doubt.alternatives[1]);
  doubt.present = 1;
  const std::vector<ShownGhost> ghosts = ghostsOf(plantInDoubt(), doubt);
  EXPECT_TRUE(ghosts[0].lines.empty());
  EXPECT_EQ(ghosts[1].lines.size(), 3U) << "to the branching, and two on";
  const std::vector<ShownGhost> rest = ghostsOfLikeliest(plantInDoubt(), {doubt});
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_EQ(rest[0].lines.size(), 3U);
  EXPECT_EQ(rest[0].number, 0);
}

/// Which of some points are those of a doubt, by their number.
std::vector<std::size_t> litOf(const Doubt& doubt, const std::vector<Eigen::Vector3d>& places) {
  RawPoints raw;
  raw.positions = places;
  const auto cloud = std::make_shared<const PointCloud>(std::move(raw));
  const Skeleton plant = plantInDoubt();
  std::vector<std::size_t> lit;
  for (const auto& dot :
       ghostOfPoints(plant, doubt, PointDistances(cloud, 0.1, plant), 0.5).lines) {
    EXPECT_EQ(dot.size(), 1U);
    for (std::size_t i = 0; i < places.size(); ++i)
      if ((dot.front() - places[i]).norm() < 1e-6) lit.push_back(i);
  }
  std::ranges::sort(lit);
  return lit;
}

TEST(DoubtGhosts, PointsOfWoodAreThoseNearestToIt) {
  const std::vector<std::size_t> lit =
      litOf(attachmentInDoubt(), {{1.5, 0.1, 1}, {0.1, 0, 0.5}, {2, 0.2, 1}, {1.5, 3, 1}});
  EXPECT_EQ(lit, (std::vector<std::size_t>{0, 2})) << "neither of the stem, nor far from all";
}

TEST(DoubtGhosts, PointsOfWhatIsMissingLieAlongItAndHaveNoWood) {
  GrownBranch branch{.on = NodeId(2), .part = {}};
  const NodeId root = branch.part.add({.position = {0, 0, 2}});
  branch.part.add({.position = {-2, 0, 2}, .parent = root, .edge = EdgeType::branching});
  const Doubt missing{.kind = Doubt::Kind::missing,
                      .node = NodeId(2),
                      .alternatives = {{.kind = Alternative::Kind::add, .branch = branch},
                                       {.kind = Alternative::Kind::asItIs}},
                      .present = 1};
  const std::vector<std::size_t> lit =
      litOf(missing, {{-1, 0, 2}, {-1, 1, 2}, {-0.1, 0, 1.9}, {-2, 0.3, 2.2}, {1, 0.1, 1}});
  EXPECT_EQ(lit, (std::vector<std::size_t>{0, 3}));
}

} // namespace
} // namespace espalier
