#include "core/project/content_hash.h"
#include "core/project/history.h"
#include "core/project/node_bytes.h"
#include "tests/core/project/edits_at_random.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <limits>

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
  const PointSet leftOut = PointSet::of({0, 7, 8, 4'000'000'000});
  const auto read = plantFrom(bytesOf(plant, leftOut));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->skeleton, plant);
  EXPECT_EQ(read->skeleton.idEnd(), plant.idEnd());
  EXPECT_EQ(read->leftOut, leftOut);
  EXPECT_EQ(plantFrom(bytesOf(Skeleton())), StoredPlant());
}

TEST(NodeBytes, OfADeltaReadBackToTheSame) {
  test::EditsAtRandom edits({.skeleton = plantWithEntities()}, 3);
  for (int i = 0; i < 200; ++i)
    for (const HistoryStep& step : edits.next().added)
      ASSERT_EQ(deltaFrom(bytesOf(step.delta, step.points)),
                (StoredDelta{step.delta, step.points}));
}

TEST(NodeBytes, ThatWereCutAreNone) {
  const std::string bytes = bytesOf(plantWithEntities(), PointSet::of({3, 4, 9}));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_FALSE(plantFrom(bytes.substr(0, size))) << size;
}

TEST(NodeBytes, ThatWereChangedAreNone) {
  const std::string bytes = bytesOf(plantWithEntities(), PointSet::of({3, 4, 9}));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    ASSERT_FALSE(plantFrom(changed)) << "byte " << i;
  }
}

// An edit of what is no number could not be undone: nothing is equal to that.
TEST(NodeBytes, OfPlacesAndRadiiThatAreNoNumbersAreNone) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite}) {
    Skeleton plant;
    SkeletonEditor editor(plant);
    (void)editor.add({.position = {0, wrong, 0}});
    EXPECT_FALSE(deltaFrom(bytesOf(editor.commit(), {})));
    EXPECT_FALSE(plantFrom(bytesOf(plant, {})));
    Skeleton thick;
    SkeletonEditor other(thick);
    (void)other.add({.radius = wrong});
    EXPECT_FALSE(deltaFrom(bytesOf(other.commit(), {})));
    EXPECT_FALSE(plantFrom(bytesOf(thick, {})));
  }
}

// A delta that is empty but for points ends with them: their count, one run, and the hash.
TEST(NodeBytes, WithRunsThatAreNoneAreNone) {
  const auto withRun = [](std::uint32_t begin, std::uint32_t end) {
    std::string bytes = bytesOf(SkeletonDelta(), PointSet::of({5}));
    const std::size_t run = bytes.size() - 8 - 8;
    for (std::size_t i = 0; i < 4; ++i) {
      bytes[run + i] = static_cast<char>((begin >> (8 * i)) & 0xFF);
      bytes[run + 4 + i] = static_cast<char>((end >> (8 * i)) & 0xFF);
    }
    bytes.resize(bytes.size() - 8);
    const std::uint64_t hash = contentHash(bytes);
    for (std::size_t i = 0; i < 8; ++i)
      bytes.push_back(static_cast<char>((hash >> (8 * i)) & 0xFF));
    return bytes;
  };
  ASSERT_TRUE(deltaFrom(withRun(5, 6)));
  EXPECT_FALSE(deltaFrom(withRun(6, 6)));
  EXPECT_FALSE(deltaFrom(withRun(6, 5)));
}

TEST(NodeBytes, OfAnotherKindAreNone) {
  EXPECT_FALSE(plantFrom("PK\3\4 something else altogether"));
  EXPECT_FALSE(deltaFrom(bytesOf(test::stick(2))));
}

} // namespace
} // namespace espalier
