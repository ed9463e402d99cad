#include "core/base/counted.h"
#include "core/base/listed.h"
#include "core/base/printable.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

TEST(Printable, KeepsWhatIsText) {
  const std::string text = "Bäume/ёлка 松 🌲.mtg";
  EXPECT_EQ(printable(text), text);
  EXPECT_TRUE(isUtf8(text));
}

TEST(Printable, TakesOutWhatSteersTheTerminalOrBreaksTheLine) {
  EXPECT_EQ(printable("a\nb\rc\td\33[2Je\7"), "a?b?c?d?[2Je?");
  EXPECT_EQ(printable("\u009b2J\u2028\u202egnp"), "?2J??gnp");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a?b");
}

TEST(Printable, TakesOutWhatIsNoUtf8) {
  for (const char* wrong :
       {"\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xff"}) {
    EXPECT_FALSE(isUtf8(wrong));
    EXPECT_EQ(printable(wrong).find_first_not_of('?'), std::string::npos);
  }
  EXPECT_EQ(printable("t\xffx"), "t?x");
}

TEST(InQuotes, CutsNoSignInTwo) {
  for (std::size_t blanks = 30; blanks < 50; ++blanks) {
    const std::string quoted = inQuotes(std::string(blanks, 'x') + "松松松松松松");
    EXPECT_EQ(quoted.find('?'), std::string::npos) << quoted;
  }
}

TEST(Counted, SaysOneOfOneAlone) {
  EXPECT_EQ(counted(1, "point"), "1 point");
  EXPECT_EQ(counted(0, "point"), "0 points");
  EXPECT_EQ(counted(2, "vertex", "vertices"), "2 vertices");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
}

TEST(FirstNotes, CountsTheRestOfMany) {
  const std::vector<ShownMessage> few = {{"a"}, {"b"}};
  EXPECT_EQ(firstNotes(few), few);
  const std::vector<ShownMessage> first = firstNotes(std::vector<ShownMessage>(500'000, {"a"}));
  EXPECT_EQ(first.size(), 21U);
  EXPECT_EQ(inEnglish(first.back()), "and 499980 notes more");
  EXPECT_EQ(inEnglish(firstNotes(std::vector<ShownMessage>(21, {"a"})).back()), "and 1 note more");
}

TEST(Listed, CountsTheRestOfMany) {
  EXPECT_EQ(listed({"a", "b"}), "'a', 'b'");
  EXPECT_THAT(listed(std::vector<std::string>(200'000, "a")), testing::EndsWith("'a', + 199990"));
}

} // namespace
} // namespace espalier
