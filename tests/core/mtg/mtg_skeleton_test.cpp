#include "core/base/error.h"
#include "core/mtg/mtg_skeleton.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/canonical.h"
#include "tests/support/shared_data.h"

#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

Imported<Skeleton> skeletonOfRows(const std::string& rows) {
  return skeletonOf(test::readMtgRows(rows).value, "plant.mtg");
}

Imported<Skeleton> skeletonOfFile(const std::filesystem::path& path) {
  std::ifstream in(path);
  return skeletonOf(readMtg(in, path.filename().string()).value, path.filename().string());
}

double lengthOf(const Skeleton& skeleton) {
  double length = 0;
  for (const NodeId id : skeleton.ids())
    if (const auto parent = skeleton[id].parent)
      length += (skeleton[id].position - skeleton[*parent].position).norm();
  return length;
}

TEST(SkeletonOf, TakesTheFinestScaleThatHasPositions) {
  const Skeleton plant =
      test::withoutEntities(skeletonOfRows("/P1/A1\t\t\t9\t9\t9\n^/E1\t\t\t1\t2\t3\t0.5\n"
                                           "\t+E2\t\t4\t5\t6\t\n^<E3\t\t\t7\t8\t9\tNA\n")
                                .value);
  ASSERT_EQ(plant.size(), 3U);
  EXPECT_EQ(plant[NodeId{0}], (Node{.position = {1, 2, 3}, .radius = 0.5}));
  EXPECT_EQ(plant[NodeId{1}],
            (Node{.position = {4, 5, 6}, .parent = NodeId{0}, .edge = EdgeType::branching}));
  EXPECT_EQ(plant[NodeId{2}], (Node{.position = {7, 8, 9}, .parent = NodeId{0}}));
}

TEST(SkeletonOf, TakesACoarserScaleIfTheFinestHasNoPositions) {
  const Skeleton plant = skeletonOfRows("/P1/A1\t\t\t9\t9\t9\n^/E1\n").value;
  ASSERT_EQ(plant.size(), 1U);
  EXPECT_EQ(plant[NodeId{0}].position, Eigen::Vector3d(9, 9, 9));
}

// E2 stands between E1 and its successor E3.
TEST(SkeletonOf, PutsVerticesWithoutPositionBetweenTheirNeighbors) {
  const Imported<Skeleton> plant =
      skeletonOfRows("/P1/A1/E1\t\t\t0\t0\t0\n\t+E2\n\t^<E3\t\t2\t2\t4\n");
  ASSERT_EQ(plant.value.size(), 3U);
  EXPECT_EQ(plant.value[NodeId{1}].position, Eigen::Vector3d(1, 1, 2));
  EXPECT_THAT(eachInEnglish(plant.notes),
              testing::ElementsAre("plant.mtg: 1 vertex has no position and is put "
                                   "evenly between neighbors"));
}

// E2 bears E3 but has no position, nor a successor: E3 comes to be attached to E1.
TEST(SkeletonOf, PassesOverVerticesWithoutPosition) {
  const Imported<Skeleton> plant =
      skeletonOfRows("/P1/A1/E1\t\t\t0\t0\t0\n\t+E2\t\t1\tnan\t1\n\t^+E3\t\t2\t2\t2\n");
  ASSERT_EQ(plant.value.size(), 2U);
  EXPECT_EQ(plant.value[NodeId{1}].parent, NodeId{0});
  EXPECT_EQ(plant.value[NodeId{1}].edge, EdgeType::branching);
  EXPECT_THAT(eachInEnglish(plant.notes),
              testing::ElementsAre("plant.mtg: 1 vertex has no position and is passed over"));
}

TEST(SkeletonOf, ReadsXyzAndHalvesTheDiameter) {
  Mtg mtg{.features = {{"X", "REAL"}, {"Y", "REAL"}, {"Z", "REAL"}, {"Diameter", "REAL"}}};
  mtg.vertices.push_back({.symbol = "N", .scale = 2, .values = {"1", "2", "3", "5"}});
  EXPECT_EQ(test::withoutEntities(skeletonOf(mtg, "plant.mtg").value)[NodeId{0}],
            (Node{.position = {1, 2, 3}, .radius = 2.5}));
}

TEST(SkeletonOf, TakesNegativeRadiiAsNotKnown) {
  const Imported<Skeleton> plant = skeletonOfRows("/P1\t\t\t1\t2\t3\t-4\n");
  EXPECT_EQ(plant.value[NodeId{0}].radius, 0);
  EXPECT_THAT(eachInEnglish(plant.notes),
              testing::ElementsAre(testing::HasSubstr("1 radius is negative")));
}

TEST(SkeletonOf, RefusesAPlantWithoutPositions) {
  EXPECT_THROW((void)skeletonOfRows("/P1\n"), Error);
  EXPECT_THROW((void)skeletonOfRows("/P1\t\t\t1\t2\n"), Error);
  EXPECT_THROW((void)skeletonOfRows("/P1\t\t\t1\t2\tinf\n"), Error);
}

// A1 begins at E1, A2 at E3; XX is no value of a node, but one of a coarser vertex.
TEST(SkeletonOf, ListsWhichUnitsBeginAtANode) {
  const Skeleton plant = skeletonOfRows("/P1\n^/A1\t\t\t9\t9\t9\n^/E1\t\t\t1\t2\t3\t0.5\n"
                                        "^<E2\t\t\t4\t5\t6\t\n\t+A2/E3\t\t7\t8\t9\n")
                             .value;
  ASSERT_EQ(plant.size(), 3U);
  EXPECT_EQ(plant[NodeId{0}].entities,
            (std::vector<Entity>{{.scale = 1, .symbol = "P", .index = 1},
                                 {.scale = 2,
                                  .symbol = "A",
                                  .index = 1,
                                  .values = {{"XX", "9"}, {"YY", "9"}, {"ZZ", "9"}}},
                                 {.scale = 3, .symbol = "E", .index = 1}}));
  EXPECT_EQ(plant[NodeId{1}].entities,
            (std::vector<Entity>{{.scale = 3, .symbol = "E", .index = 2}}));
  EXPECT_EQ(plant[NodeId{2}].entities,
            (std::vector<Entity>{{.scale = 2, .symbol = "A", .index = 2},
                                 {.scale = 3, .symbol = "E", .index = 3}}));
}

struct Reference {
  const char* file;
  std::size_t nodes;
};

void PrintTo(const Reference& reference, std::ostream* out) {
  *out << reference.file;
}

class SkeletonOfReference : public testing::TestWithParam<Reference> {};

TEST_P(SkeletonOfReference, IsOnePlantWithAllItsNodes) {
  ESPALIER_SHARED_FILE(path, GetParam().file);
  const Imported<Skeleton> plant = skeletonOfFile(path);
  EXPECT_EQ(plant.value.size(), GetParam().nodes);
  EXPECT_EQ(plant.value.roots().size(), 1U);
  EXPECT_THAT(plant.notes, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Experts, SkeletonOfReference,
                         testing::Values(Reference{"puu1/expert.mtg", 3358},
                                         Reference{"puu1/thesis_automatic.mtg", 4241},
                                         Reference{"puu1/expert_later_revision.mtg", 3966},
                                         Reference{"structures/puu3_reference.mtg", 3281},
                                         Reference{"structures/cherry_reference.mtg", 6128},
                                         Reference{"structures/arabidopsis_reference.mtg", 208},
                                         Reference{"A3B4/plantscan3d.mtg", 610},
                                         Reference{"mtg/reconstructed_appletree.mtg", 356}));

TEST(SkeletonOf, PineOfTheExpertHasItsLength) {
  ESPALIER_SHARED_FILE(path, "puu1/expert.mtg");
  EXPECT_NEAR(lengthOf(skeletonOfFile(path).value), 156485.72, 0.005);
}

} // namespace
} // namespace espalier
