#include "core/io/dropped.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Format& named(std::string_view name) {
  for (const Format& format : formats())
    if (format.name == name) return format;
  throw std::invalid_argument(std::string(name));
}

constexpr Carried everything{.radii = true,
                             .edgeTypes = true,
                             .severalTrees = true,
                             .entities = true,
                             .labels = true,
                             .features = true,
                             .dates = true};

Skeleton oneWithEverything() {
  Skeleton plant = test::fork(2);
  Entity unit{.scale = 1, .symbol = "U", .index = 3, .values = {{"state", "A"}}};
  unit.later = {{{"state", "B"}}};
  plant.add({.position = {9, 0, 0}, .entities = {unit}});
  return plant;
}

TEST(DroppedBy, IsNothingWhereAllIsKept) {
  const Format format{.name = "X", .content = Content::structure, .carried = everything};
  EXPECT_THAT(eachInEnglish(droppedBy(format, oneWithEverything())), IsEmpty());
}

TEST(DroppedBy, ListsEachThingThatIsThereAndNotKept) {
  const Format format{.name = "X", .content = Content::structure};
  EXPECT_THAT(
      eachInEnglish(droppedBy(format, oneWithEverything())),
      ElementsAre("X keeps no radii: how thick the nodes are is not written",
                  "X keeps no edge types: which child continues an axis is not written",
                  "X keeps one tree only: the others are not written",
                  "X keeps no classes or scales: units and axes that the nodes belong to are not "
                  "written",
                  "X keeps no labels: indices and aliases are not written",
                  "X keeps no features: values beside position and radius are not written",
                  "X keeps one date only: values at later dates are not written"));
}

TEST(DroppedBy, SaysNothingOfWhatIsNotThere) {
  Skeleton bare;
  bare.add({.position = {0, 0, 1}, .parent = bare.add({})});
  EXPECT_THAT(eachInEnglish(droppedBy({.name = "X", .content = Content::structure}, bare)),
              IsEmpty());
}

TEST(DroppedBy, SaysThatOnlyAProjectKeepsReviewAndUnitStarts) {
  Skeleton plant = test::stick(4);
  plant.setReview(NodeId{1}, {.state = ReviewState::doubtful, .reviewer = "Ada"});
  EXPECT_THAT(
      eachInEnglish(droppedBy(named("MTG"), plant)),
      ElementsAre(
          "MTG keeps no review: marks, comments and signatures are not written; only a project "
          "keeps them"));
  plant.setReview(NodeId{1}, {});
  plant.setReview(NodeId{2}, {.comment = "a spur?"});
  plant.setMarked(NodeId{3}, true);
  EXPECT_THAT(
      eachInEnglish(droppedBy(named("MTG"), plant)),
      ElementsAre(
          "MTG keeps no review: marks, comments and signatures are not written; only a project "
          "keeps them",
          "MTG keeps no marks of unit starts: they are not written; only a project "
          "keeps them"));
}

TEST(DroppedBy, SaysThatSwcLosesEdgeTypes) {
  EXPECT_THAT(eachInEnglish(droppedBy(named("SWC"), test::fork(2))),
              ElementsAre("SWC keeps no edge types: which child continues an axis is not written"));
  EXPECT_THAT(eachInEnglish(droppedBy(named("SWC"), test::stick(4))), IsEmpty());
}

TEST(DroppedBy, SaysNothingOfAPlantInTheFormatsOfTheEditor) {
  EXPECT_THAT(eachInEnglish(droppedBy(named("MTG"), test::randomPlant(20, 1))), IsEmpty());
  EXPECT_THAT(eachInEnglish(droppedBy(named("node list"), test::randomPlant(20, 1))), IsEmpty());
}

} // namespace
} // namespace espalier
