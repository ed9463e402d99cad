#include "core/base/shown_message.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(ShownMessage, PutsItsValuesIntoTheSentence) {
  EXPECT_EQ(inEnglish(ShownMessage{"no radius is measured"}), "no radius is measured");
  EXPECT_EQ(inEnglish(ShownMessage{"node %1 has %2 successors", {"12", "3"}}),
            "node 12 has 3 successors");
  EXPECT_EQ(inEnglish(ShownMessage{"%2 from node %1 on", {"12", "4 mm"}}), "4 mm from node 12 on");
}

TEST(ShownMessage, TakesAValueAsItIs) {
  EXPECT_EQ(inEnglish(ShownMessage{"no column %1 in %2", {"%2", "a.csv"}}),
            "no column %2 in a.csv");
  EXPECT_EQ(inEnglish(ShownMessage{"only %1 % of them, 5 %", {"30"}}), "only 30 % of them, 5 %");
  EXPECT_EQ(inEnglish(ShownMessage{"%1 and %3", {"one"}}), "one and %3") << "no value for it";
}

TEST(ShownError, SaysTheSentenceInEnglish) {
  const ShownError error({"node %1 is a root", {"7"}});
  EXPECT_STREQ(error.what(), "node 7 is a root");
  EXPECT_EQ(error.message(), (ShownMessage{"node %1 is a root", {"7"}}));
}

TEST(FilePlace, StandsBeforeTheSentence) {
  EXPECT_EQ(inEnglish(ShownMessage{"is empty", {}, FilePlace{"oak.ply"}}), "oak.ply: is empty");
  EXPECT_EQ(inEnglish(FilePlace{"oak.mtg", 12}), "oak.mtg, line 12");
  EXPECT_EQ(inEnglish(FilePlace{"oak.mtg", 12, 3}), "oak.mtg, line 12, column 3");
  EXPECT_EQ(inEnglish(FilePlace{.file = "oak.las", .byte = 0}), "oak.las, byte 0");
  const ShownError error({"found %1", {"%1"}, FilePlace{"%1.csv", 2}});
  EXPECT_STREQ(error.what(), "%1.csv, line 2: found %1") << "names are taken as they are";
}

TEST(MessageOf, AnErrorIsWhatItSays) {
  const ShownMessage message{"found %1", {"a"}, FilePlace{"b.csv"}};
  EXPECT_EQ(messageOf(ShownError(message)), message);
  EXPECT_EQ(inEnglish(messageOf(Error("a disk is %1 full"))), "a disk is %1 full");
}

} // namespace
} // namespace espalier
