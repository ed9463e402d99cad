#include "core/base/error.h"
#include "core/project/content_hash.h"
#include "core/project/history.h"
#include "core/project/node_bytes.h"
#include "tests/core/project/edits_at_random.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace espalier {
namespace {

Skeleton plantWithEntities() {
  Skeleton plant = test::randomPlant(40, 5);
  Entity entity{.scale = 4, .symbol = "U", .index = -2, .alias = "v7"};
  entity.values = {{"Length", "12.5"}, {"Note", std::string("a\0b", 3)}};
  entity.later = {{}, {{"Length", "13"}}};
  plant.add({.radius = 0.25, .parent = NodeId{3}, .entities = {entity, {.symbol = "I"}}});
  const Entity shoot{.scale = 2, .symbol = "S", .index = LabelIndex::in("16.01")};
  plant.setMarked(NodeId{5}, true);
  plant.setReview(NodeId{6}, {ReviewState::doubtful, "crosses its neighbor?", "Anna"});
  plant.setEntities(NodeId{7}, {shoot});
  plant.setReview(NodeId{40}, {ReviewState::reviewed, {}, "Émile"});
  plant.erase(plant.add({.parent = NodeId{4}})); // its id stays handed out
  return plant;
}

TEST(NodeBytes, OfASkeletonReadBackToTheSame) {
  const Skeleton plant = plantWithEntities();
  const PointSet leftOut = PointSet::of({0, 7, 8, 4'000'000'000});
  const OrganMarks organs =
      OrganMarks().with(PointSet::of({1, 2}), Organ::petiole).with(leftOut, Organ::needle);
  const auto read = plantFrom(bytesOf(plant, leftOut, organs));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->skeleton, plant);
  EXPECT_EQ(read->skeleton.idEnd(), plant.idEnd());
  EXPECT_EQ(read->leftOut, leftOut);
  EXPECT_EQ(read->organs, organs);
  EXPECT_EQ(plantFrom(bytesOf(Skeleton())), StoredPlant());
}

TEST(NodeBytes, OfADeltaReadBackToTheSame) {
  test::EditsAtRandom edits({.skeleton = plantWithEntities()}, 3);
  for (int i = 0; i < 200; ++i)
    for (const HistoryStep& step : edits.next().added)
      ASSERT_EQ(deltaFrom(bytesOf(step.delta, step.points, step.organs)),
                (StoredDelta{step.delta, step.points, step.organs}));
}

const OrganMarks someBlades = OrganMarks().with(PointSet::of({3, 4, 6}), Organ::blade);

TEST(NodeBytes, ThatWereCutAreNone) {
  const std::string bytes = bytesOf(plantWithEntities(), PointSet::of({3, 4, 9}), someBlades);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_FALSE(plantFrom(bytes.substr(0, size))) << size;
}

TEST(NodeBytes, ThatWereChangedAreNone) {
  const std::string bytes = bytesOf(plantWithEntities(), PointSet::of({3, 4, 9}), someBlades);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    ASSERT_FALSE(plantFrom(changed)) << "byte " << i;
  }
}

std::string littleEndian(std::uint64_t value) {
  std::string bytes;
  for (int i = 0; i < 8; ++i)
    bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
  return bytes;
}

/// `bytes` with one number in place of another, and the hash of that.
std::string withNumber(std::string bytes, double number, double instead) {
  bytes.resize(bytes.size() - 8);
  const std::size_t at = bytes.find(littleEndian(std::bit_cast<std::uint64_t>(number)));
  EXPECT_NE(at, std::string::npos);
  bytes.replace(at, 8, littleEndian(std::bit_cast<std::uint64_t>(instead)));
  return bytes + littleEndian(contentHash(bytes));
}

// An edit of what is no number could not be undone: nothing is equal to that.
TEST(NodeBytes, OfPlacesAndRadiiThatAreNoNumbersAreNone) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr double place = 12.625;
  constexpr double radius = 0.3125;
  Skeleton plant;
  SkeletonEditor editor(plant);
  (void)editor.add({.position = {0, place, 0}, .radius = radius});
  const std::string delta = bytesOf(editor.commit(), {});
  const std::string whole = bytesOf(plant, {});
  EXPECT_TRUE(deltaFrom(withNumber(delta, place, 7)));
  EXPECT_TRUE(plantFrom(withNumber(whole, radius, 7)));
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite, 1e13})
    for (const double number : {place, radius}) {
      EXPECT_FALSE(deltaFrom(withNumber(delta, number, wrong)));
      EXPECT_FALSE(plantFrom(withNumber(whole, number, wrong)));
    }
  for (const Node& node : {Node{.position = {0, 1e13, 0}}, Node{.radius = infinite}})
    EXPECT_THROW((void)editor.add(node), Error) << "nor comes any into a plant";
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
    return bytes + littleEndian(contentHash(bytes));
  };
  ASSERT_TRUE(deltaFrom(withRun(5, 6)));
  EXPECT_FALSE(deltaFrom(withRun(6, 6)));
  EXPECT_FALSE(deltaFrom(withRun(6, 5)));
}

// Where there is no such organ, an older program may read them.
TEST(NodeBytes, AreOfVersionSixWhereOrgansWereSetByHand) {
  EXPECT_EQ(bytesOf(SkeletonDelta(), {}, someBlades).front(), 6);
  EXPECT_EQ(bytesOf(Skeleton(), {}, someBlades).front(), 6);
  EXPECT_EQ(bytesOf(SkeletonDelta(), PointSet::of({5})).front(), 3);
}

// A program that knows version 3 alone would misread the index; what it can read, it may.
TEST(NodeBytes, AreOfVersionFourWhereAnIndexIsAText) {
  EXPECT_EQ(bytesOf(plantWithEntities()).front(), 4);
  Skeleton plant = plantWithEntities();
  plant.setEntities(NodeId{7}, {});
  EXPECT_EQ(bytesOf(plant).front(), 3);
  EXPECT_EQ(plantFrom(bytesOf(plant))->skeleton, plant);
  std::string later = bytesOf(plant);
  later.resize(later.size() - 8);
  later.front() = 6;
  EXPECT_FALSE(plantFrom(later + littleEndian(contentHash(later))));
}

TEST(NodeBytes, AreOfVersionFiveWhereRadiiHaveAnOrigin) {
  Skeleton plant = test::stick(3);
  EXPECT_EQ(bytesOf(plant).front(), 3);
  plant.setRadius(NodeId{1}, 0.2, {RadiusSource::corrected, 0.5F, 2.25F});
  plant.setRadius(NodeId{2}, 0.1, {.source = RadiusSource::byHand});
  EXPECT_EQ(bytesOf(plant).front(), 5);
  EXPECT_EQ(plantFrom(bytesOf(plant))->skeleton, plant);
}

TEST(NodeBytes, OfOriginsThatAreNoneAreNone) {
  Skeleton plant = test::stick(1);
  plant.setRadius(NodeId{0}, 0.2, {RadiusSource::corrected, 0.5F, 2.25F});
  std::string whole = bytesOf(plant);
  whole.resize(whole.size() - 8);
  const std::size_t source = whole.size() - 13; // before two bounds and the number of runs
  const auto with = [&](std::size_t place, char instead) {
    std::string bytes = whole;
    bytes[place] = instead;
    return plantFrom(bytes + littleEndian(contentHash(bytes)));
  };
  EXPECT_TRUE(with(source, 3));
  EXPECT_FALSE(with(source, 5)) << "no such source";
  EXPECT_FALSE(with(source + 8, '\0')) << "the upper bound below the lower one";
  EXPECT_FALSE(with(source + 4, '\xff')) << "a lower bound below 0";
  plant.setRadius(NodeId{0}, 0.2, {RadiusSource::measured, 2, 1});
  EXPECT_THROW((void)bytesOf(plant), Error) << "nor is it written";
}

TEST(NodeBytes, NameErasedIdsOnlyAsFarAsAnyFileMay) {
  EXPECT_EQ(storedIdEnd(1000, 5), 1000U);
  EXPECT_EQ(storedIdEnd(idsFor(0), 5), idsFor(0));
  EXPECT_EQ(storedIdEnd(idsFor(0) + 1, 5), 5U) << "a project with these alone would be refused";
}

TEST(NodeBytes, OfAnotherKindAreNone) {
  EXPECT_FALSE(plantFrom("PK\3\4 something else altogether"));
  EXPECT_FALSE(deltaFrom(bytesOf(test::stick(2))));
}

} // namespace
} // namespace espalier
