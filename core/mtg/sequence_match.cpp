#include "core/mtg/sequence_match.h"

#include <algorithm>

namespace espalier {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

constexpr std::ptrdiff_t nowhere = -2;

/// How far in `a` one gets on each diagonal (place in a less place in b) with so many differences.
struct Reach {
  std::vector<std::ptrdiff_t> farthest; // of the diagonals from -differences to differences

  [[nodiscard]] std::ptrdiff_t on(std::ptrdiff_t diagonal) const {
    const auto middle = static_cast<std::ptrdiff_t>(farthest.size() / 2);
    const std::ptrdiff_t at = diagonal + middle;
    return at < 0 || at >= static_cast<std::ptrdiff_t>(farthest.size())
               ? nowhere
               : farthest[static_cast<std::size_t>(at)];
  }
};

/// Where one more difference leads to on a diagonal, and whether it takes a place out of `a` (else
/// it puts one of `b` in).
struct Difference {
  std::ptrdiff_t x = nowhere;
  bool isTakenOut = false;
};

Difference afterDifference(const Reach& before, std::ptrdiff_t diagonal, std::ptrdiff_t aSize,
                           std::ptrdiff_t bSize) {
  const std::ptrdiff_t out = before.on(diagonal - 1);
  const std::ptrdiff_t in = before.on(diagonal + 1);
  Difference best;
  if (out != nowhere && out < aSize) best = {out + 1, true};
  if (in > best.x && in - diagonal <= bSize) best = {in, false};
  return best;
}

/// The common places, from the end back.
Pairs pairsAlong(const std::vector<Reach>& reaches, std::ptrdiff_t aSize, std::ptrdiff_t bSize) {
  Pairs pairs;
  std::ptrdiff_t x = aSize;
  std::ptrdiff_t diagonal = aSize - bSize;
  for (std::size_t differences = reaches.size() - 1;; --differences) {
    const Difference last = differences == 0
                                ? Difference{.x = 0}
                                : afterDifference(reaches[differences - 1], diagonal, aSize, bSize);
    for (; x > last.x; --x)
      pairs.emplace_back(x - 1, x - 1 - diagonal);
    if (differences == 0) break;
    diagonal += last.isTakenOut ? -1 : 1;
    x = reaches[differences - 1].on(diagonal);
  }
  std::ranges::reverse(pairs);
  return pairs;
}

} // namespace

std::optional<Pairs> matchSequences(const std::vector<int>& a, const std::vector<int>& b,
                                    std::size_t mostDifferences) {
  const auto aSize = static_cast<std::ptrdiff_t>(a.size());
  const auto bSize = static_cast<std::ptrdiff_t>(b.size());
  std::vector<Reach> reaches;
  for (std::size_t differences = 0; differences <= mostDifferences; ++differences) {
    const auto widest = static_cast<std::ptrdiff_t>(differences);
    Reach reach{std::vector<std::ptrdiff_t>(2 * differences + 1, nowhere)};
    for (std::ptrdiff_t diagonal = -widest; diagonal <= widest; diagonal += 2) {
      std::ptrdiff_t x =
          differences == 0 ? 0 : afterDifference(reaches.back(), diagonal, aSize, bSize).x;
      if (x == nowhere) continue;
      while (x < aSize && x - diagonal < bSize &&
             a[static_cast<std::size_t>(x)] == b[static_cast<std::size_t>(x - diagonal)])
        ++x;
      reach.farthest[static_cast<std::size_t>(diagonal + widest)] = x;
      if (x != aSize || x - diagonal != bSize) continue;
      reaches.push_back(std::move(reach));
      return pairsAlong(reaches, aSize, bSize);
    }
    reaches.push_back(std::move(reach));
  }
  return std::nullopt;
}

} // namespace espalier
