#include "core/base/shown_message.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(ShownMessage, PutsItsValuesIntoTheSentence) {
  EXPECT_EQ(inEnglish({"no radius is measured"}), "no radius is measured");
  EXPECT_EQ(inEnglish({"node %1 has %2 successors", {"12", "3"}}), "node 12 has 3 successors");
  EXPECT_EQ(inEnglish({"%2 from node %1 on", {"12", "4 mm"}}), "4 mm from node 12 on");
}

TEST(ShownMessage, TakesAValueAsItIs) {
  EXPECT_EQ(inEnglish({"no column %1 in %2", {"%2", "a.csv"}}), "no column %2 in a.csv");
  EXPECT_EQ(inEnglish({"only %1 % of them, 5 %", {"30"}}), "only 30 % of them, 5 %");
  EXPECT_EQ(inEnglish({"%1 and %3", {"one"}}), "one and %3") << "no value for it";
}

TEST(ShownError, SaysTheSentenceInEnglish) {
  const ShownError error({"node %1 is a root", {"7"}});
  EXPECT_STREQ(error.what(), "node 7 is a root");
  EXPECT_EQ(error.message(), (ShownMessage{"node %1 is a root", {"7"}}));
}

} // namespace
} // namespace espalier
