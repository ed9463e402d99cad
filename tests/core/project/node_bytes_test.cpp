#include "core/project/history.h"
#include "core/project/node_bytes.h"
#include "tests/core/project/edits_at_random.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

Skeleton plantWithEntities() {
  Skeleton plant = test::randomPlant(40, 5);
  Entity entity{.scale = 4, .symbol = "U", .index = -2, .alias = "v7"};
  entity.values = {{"Length", "12.5"}, {"Note", std::string("a\0b", 3)}};
  entity.later = {{}, {{"Length", "13"}}};
  plant.add({.radius = 0.25, .parent = NodeId{3}, .entities = {entity, {.symbol = "I"}}});
  plant.setMarked(NodeId{5}, true);
  plant.setReview(NodeId{6}, {ReviewState::doubtful, "crosses its neighbor?", "Anna"});
  plant.setReview(NodeId{40}, {ReviewState::reviewed, {}, "Émile"});
  plant.erase(plant.add({.parent = NodeId{4}})); // its id stays handed out
  return plant;
}

TEST(NodeBytes, OfASkeletonReadBackToTheSame) {
  const Skeleton plant = plantWithEntities();
  const auto read = skeletonFrom(bytesOf(plant));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, plant);
  EXPECT_EQ(read->idEnd(), plant.idEnd());
  EXPECT_EQ(skeletonFrom(bytesOf(Skeleton())), Skeleton());
}

TEST(NodeBytes, OfADeltaReadBackToTheSame) {
  test::EditsAtRandom edits({.skeleton = plantWithEntities()}, 3);
  for (int i = 0; i < 200; ++i)
    for (const HistoryStep& step : edits.next().added)
      ASSERT_EQ(deltaFrom(bytesOf(step.delta)), step.delta);
}

TEST(NodeBytes, ThatWereCutAreNone) {
  const std::string bytes = bytesOf(plantWithEntities());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_FALSE(skeletonFrom(bytes.substr(0, size))) << size;
}

TEST(NodeBytes, ThatWereChangedAreNone) {
  const std::string bytes = bytesOf(plantWithEntities());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    ASSERT_FALSE(skeletonFrom(changed)) << "byte " << i;
  }
}

TEST(NodeBytes, OfAnotherKindAreNone) {
  EXPECT_FALSE(skeletonFrom("PK\3\4 something else altogether"));
  EXPECT_FALSE(deltaFrom(bytesOf(test::stick(2))));
}

} // namespace
} // namespace espalier
