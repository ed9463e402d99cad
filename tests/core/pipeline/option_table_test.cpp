#include "core/pipeline/option_table.h"

#include <gtest/gtest.h>

#include <numbers>

namespace espalier {
namespace {

enum class Flow { slow, fast };

struct Water {
  double depth = 0.5;
  double turn = std::numbers::pi / 3;
};

struct Options {
  Flow flow = Flow::fast;
  bool isDry = false;
  Length width = spacings(2.5);
  Water water;
};

OptionTable<Options> table() {
  OptionTable<Options> table;
  table.add({.name = "flow",
             .label = "Flow",
             .kind = OptionKind::choice,
             .help = "How it flows.",
             .choices = {{"slow", "Slow"}, {"fast", "Fast"}}},
            &Options::flow);
  table.add(flagOption("dry", "Dry", "Whether it is dry."), &Options::isDry);
  table.add(lengthOption("width", "Width", 1, 10, "How wide it is."), &Options::width);
  table.add(ratioOption("depth", "Depth", 0, 1, "How deep it is."), &Options::water, &Water::depth);
  table.add(angleOption("turn", "Turn", 0, 90, "How much it bends."), &Options::water,
            &Water::turn);
  return table;
}

const Option& flow() {
  static const OptionTable<Options> all = table();
  return all.descriptions()[0];
}

const Option& dry() {
  static const OptionTable<Options> all = table();
  return all.descriptions()[1];
}

TEST(OptionTable, TurnsWordsIntoMembers) {
  const Options options =
      table().with({*flow().valueOf("slow"), *dry().valueOf("yes"), 2, 0.5, 60});
  EXPECT_EQ(options.flow, Flow::slow);
  EXPECT_TRUE(options.isDry);
}

TEST(OptionTable, ReadsDefaultsFromTheStruct) {
  const std::vector<Option> all = table().descriptions();
  EXPECT_EQ(all[2].rule, spacings(2.5));
  EXPECT_EQ(all[3].rule, fixedAt(0.5));
  EXPECT_EQ(all[4].rule, fixedAt(60)) << "in degrees, not nearly so";
}

TEST(OptionTable, StartsFromOtherDefaultsWhereMethodsShareAStruct) {
  OptionTable<Water> deep(Water{.depth = 0.75});
  deep.add(angleOption("turn", "Turn", 0, 90, "How much it bends."), &Water::turn);
  EXPECT_EQ(deep.with({30}).depth, 0.75);
}

TEST(OptionTable, SetsMembersOfMembers) {
  const Options options = table().with({0, 0, 3, 0.25, 90});
  EXPECT_EQ(options.width, 3);
  EXPECT_EQ(options.water.depth, 0.25);
  EXPECT_DOUBLE_EQ(options.water.turn, std::numbers::pi / 2);
}

TEST(Length, IsNoneUntilItsRuleIsApplied) {
  EXPECT_EQ(Length(spacings(2.5)), 0);
  EXPECT_EQ(Length(0.5), 0.5);
}

TEST(OptionTable, KnowsTheRangeOfWords) {
  EXPECT_EQ(flow().range({}), std::pair(0.0, 1.0));
  EXPECT_EQ(dry().range({}), std::pair(0.0, 1.0));
}

TEST(Option, NamesItsDefaultByAWord) {
  EXPECT_EQ(flow().ruleText(), "fast");
  EXPECT_EQ(dry().ruleText(), "no");
}

TEST(Option, TakesItsOwnWordsOnly) {
  for (const Choice& choice : flow().choices)
    EXPECT_EQ(flow().wordFor(flow().valueOf(choice.name).value()), choice.name);
  EXPECT_EQ(dry().wordFor(dry().valueOf("true").value()), "yes");
  EXPECT_FALSE(flow().valueOf("1"));
  EXPECT_FALSE(flow().valueOf("yes"));
  EXPECT_FALSE(dry().valueOf("2"));
  EXPECT_EQ(flow().words(), "slow, fast");
}

} // namespace
} // namespace espalier
