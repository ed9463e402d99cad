#include "core/base/error.h"
#include "tests/support/plants.h"
#include "ui/tools/node_choices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;

std::vector<NodeId> choose(const QString& id, const Skeleton& plant,
                           const std::vector<NodeId>& nodes) {
  const std::vector<NodeChoice> choices = nodeChoices();
  const auto found = std::ranges::find(choices, id, &NodeChoice::id);
  EXPECT_NE(found, choices.end()) << id.toStdString();
  return found->choose(plant, nodes);
}

TEST(NodeChoices, HaveTheDigitsInTheOrderOfTheSheet) {
  QStringList ids;
  for (int digit = 1; digit <= 7; ++digit)
    for (const NodeChoice& choice : nodeChoices())
      if (choice.shortcuts.contains(QKeySequence(Qt::Key_0 + digit))) ids.append(choice.id);
  EXPECT_EQ(ids, QStringList({"select_downstream", "select_to_root", "select_axis", "select_order",
                              "select_tree", "invert_selection", "select_unreviewed"}));
}

TEST(NodeChoices, ChooseWhatTheirNamesSay) {
  const Skeleton plant = test::fork(3);
  EXPECT_EQ(choose("select_downstream", plant, {test::forkTop}).size(), 4U);
  EXPECT_THAT(choose("select_to_root", plant, {NodeId{3}}),
              ElementsAre(NodeId{3}, test::forkTop, test::forkRoot));
  EXPECT_EQ(choose("select_axis", plant, {NodeId{2}}).size(), 3U);
  EXPECT_EQ(choose("select_order", plant, {NodeId{3}}).size(), 2U);
  EXPECT_EQ(choose("select_tree", plant, {NodeId{3}}).size(), 5U);
  EXPECT_EQ(choose("invert_selection", plant, {}).size(), 5U);
  EXPECT_EQ(choose("grow_selection", plant, {test::forkRoot}).size(), 2U);
  EXPECT_THAT(choose("shrink_selection", plant, {NodeId{3}}), testing::IsEmpty());
  EXPECT_EQ(choose("select_similar", plant, {NodeId{3}}).size(), 5U);
  EXPECT_THAT(choose("select_path", plant, {NodeId{2}, NodeId{4}}),
              ElementsAre(NodeId{2}, test::forkTop, NodeId{4}));
}

TEST(NodeChoices, SayWhatIsMissing) {
  EXPECT_THROW((void)choose("select_path", test::fork(3), {NodeId{2}}), Error);
  EXPECT_THROW((void)choose("select_duplicates", test::fork(3), {}), Error);
  EXPECT_THROW((void)choose("select_duplicated_branches", test::fork(3), {}), Error);
}

TEST(NodeChoices, FindWhatIsToDoOrDoubtful) {
  Skeleton plant = test::stick(4);
  plant.setReview(NodeId{0}, {ReviewState::reviewed});
  plant.setReview(NodeId{2}, {ReviewState::doubtful});
  EXPECT_THAT(choose("select_unreviewed", plant, {}), ElementsAre(NodeId{1}, NodeId{2}, NodeId{3}));
  for (const NodeId id : plant.ids())
    plant.setReview(id, {ReviewState::reviewed});
  EXPECT_THROW((void)choose("select_unreviewed", plant, {}), Error);
}

TEST(NodeChoices, FindNodesThatLieTogether) {
  Skeleton plant = test::stick(5);
  plant.add({.position = {0.01, 0, 2}, .parent = NodeId{4}});
  EXPECT_THAT(choose("select_duplicates", plant, {}),
              testing::UnorderedElementsAre(NodeId{2}, NodeId{5}));
}

} // namespace
} // namespace espalier
