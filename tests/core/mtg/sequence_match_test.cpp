#include "core/base/random.h"
#include "core/mtg/sequence_match.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

constexpr std::size_t all = 1000;

/// The length of a longest common subsequence, by the table of all beginnings.
std::size_t lengthOfLongest(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<std::vector<std::size_t>> longest(a.size() + 1,
                                                std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j)
      longest[i][j] = a[i - 1] == b[j - 1] ? longest[i - 1][j - 1] + 1
                                           : std::max(longest[i - 1][j], longest[i][j - 1]);
  return longest[a.size()][b.size()];
}

TEST(MatchSequences, FindsWhatBothHave) {
  EXPECT_THAT(*matchSequences({}, {}, all), IsEmpty());
  EXPECT_THAT(*matchSequences({1, 2}, {}, all), IsEmpty());
  EXPECT_THAT(*matchSequences({1, 2}, {3}, all), IsEmpty());
  EXPECT_THAT(*matchSequences({1, 2, 3}, {1, 3}, all), ElementsAre(Pair(0, 0), Pair(2, 1)));
  EXPECT_THAT(*matchSequences({1, 3}, {1, 2, 3}, all), ElementsAre(Pair(0, 0), Pair(1, 2)));
}

TEST(MatchSequences, GivesUpBeyondSoManyDifferences) {
  EXPECT_FALSE(matchSequences({1, 2, 3}, {4, 5}, 4));
  EXPECT_TRUE(matchSequences({1, 2, 3}, {4, 5}, 5));
}

TEST(MatchSequences, IsAsLongAsCanBe) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    std::vector<int> a(random.below(20));
    std::vector<int> b(random.below(20));
    for (std::vector<int>* each : {&a, &b})
      for (int& number : *each)
        number = static_cast<int>(random.below(4));
    const auto pairs = matchSequences(a, b, all);
    ASSERT_TRUE(pairs);
    EXPECT_EQ(pairs->size(), lengthOfLongest(a, b));
    for (std::size_t k = 0; k < pairs->size(); ++k) {
      EXPECT_EQ(a[(*pairs)[k].first], b[(*pairs)[k].second]);
      if (k > 0) {
        EXPECT_LT((*pairs)[k - 1].first, (*pairs)[k].first);
        EXPECT_LT((*pairs)[k - 1].second, (*pairs)[k].second);
      }
    }
  }
}

} // namespace
} // namespace espalier
