#include "core/skeleton/label_index.h"

#include <gmock/gmock.h>
#include <limits>

namespace espalier {
namespace {

std::string nextOf(const char* text) {
  const auto next = LabelIndex::in(text)->next();
  return next ? next->text() : "none";
}

TEST(LabelIndex, KeepsWhatIsTyped) {
  for (const char* text : {"0", "3", "16.1", "016.01", "2.1.3", "2147483647"})
    EXPECT_EQ(LabelIndex::in(text)->text(), text);
  EXPECT_THAT(LabelIndex::in("16.01")->parts(), testing::ElementsAre(16, 1));
  EXPECT_EQ(LabelIndex(7).text(), "7");
  EXPECT_TRUE(LabelIndex::in("7")->isPlain());
  EXPECT_FALSE(LabelIndex::in("07")->isPlain());
  EXPECT_FALSE(LabelIndex::in("7.0")->isPlain());
}

TEST(LabelIndex, IsOfNumbersAndSingleDots) {
  for (const char* text : {"", ".", "1.", ".1", "1..2", "-1", "+1", "1 2", "a", "1a", "2147483648"})
    EXPECT_FALSE(LabelIndex::in(text)) << text;
}

TEST(LabelIndex, CountsUpItsLastNumber) {
  EXPECT_EQ(nextOf("3"), "4");
  EXPECT_EQ(nextOf("16.2"), "16.3");
  EXPECT_EQ(nextOf("16.9"), "16.10");
  EXPECT_EQ(nextOf("08"), "09");
  EXPECT_EQ(nextOf("09"), "10");
  EXPECT_EQ(nextOf("2.09"), "2.10");
  EXPECT_EQ(nextOf("2147483647"), "none");
}

TEST(IndicesInUse, GoOnAtTheNextPlaceIfAllHaveADot) {
  IndicesInUse indices;
  EXPECT_EQ(indices.next(), 1);
  indices.take(*LabelIndex::in("16.10"));
  indices.take(*LabelIndex::in("16.9"));
  EXPECT_EQ(indices.next(), LabelIndex::in("17.1"));
  EXPECT_EQ(indices.nextAtPlace(), LabelIndex::in("16.11"));
  indices.take(3);
  EXPECT_EQ(indices.next(), 17) << "not all have a dot";
  indices.take(std::numeric_limits<int>::max());
  EXPECT_EQ(indices.next(), std::nullopt);
}

} // namespace
} // namespace espalier
