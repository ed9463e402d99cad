#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace espalier::test {

/// Spoils inputs as disks, transfers and attackers do: seeded, so that a failure comes again.
///
/// Each input begins as one of the corpus, then up to eight times: bits flip, bytes change or
/// double or vanish, numbers grow, the end is cut off, a stretch of another input comes in.
class Mutation {
public:
  /// pre: corpus is not empty, and outlives this
  Mutation(const std::vector<std::string>& corpus, std::uint64_t seed);

  [[nodiscard]] std::string next();

private:
  [[nodiscard]] std::size_t below(std::size_t end); // pre: end > 0
  void spoil(std::string& input);
  void splice(std::string& input);

  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_;
};

} // namespace espalier::test
