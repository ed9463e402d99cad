#include "core/pipeline/option_table.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

enum class Flow { slow, fast };

struct Options {
  Flow flow = Flow::slow;
  bool isDry = false;
};

OptionTable<Options> table() {
  OptionTable<Options> table;
  table.add({.name = "flow",
             .label = "Flow",
             .kind = OptionKind::choice,
             .rule = fixedAt(1),
             .help = "How it flows.",
             .choices = {{"slow", "Slow"}, {"fast", "Fast"}}},
            &Options::flow);
  table.add({.name = "dry",
             .label = "Dry",
             .kind = OptionKind::flag,
             .rule = fixedAt(0),
             .help = "Whether it is dry."},
            &Options::isDry);
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
  const Options options = table().with({*flow().valueOf("fast"), *dry().valueOf("yes")});
  EXPECT_EQ(options.flow, Flow::fast);
  EXPECT_TRUE(options.isDry);
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
