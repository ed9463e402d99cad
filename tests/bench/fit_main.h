#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>

namespace espalier {

/// How many plants odds are fitted on, and how many others they are judged by.
struct FitCounts {
  int plants = 120;
  int others = 60;

  [[nodiscard]] std::uint64_t lastFitted() const { return static_cast<std::uint64_t>(plants); }
  [[nodiscard]] std::uint64_t lastJudged() const {
    return static_cast<std::uint64_t>(plants) + static_cast<std::uint64_t>(others);
  }
};

/// As `--plants N --others M` say, or else as `counts` are.
[[nodiscard]] inline FitCounts fitCounts(int argc, char** argv, FitCounts counts = {}) {
  for (int i = 1; i + 1 < argc; i += 2)
    (std::string(argv[i]) == "--plants" ? counts.plants : counts.others) = std::atoi(argv[i + 1]);
  return counts;
}

/// What `of` finds in the plants of these numbers, one behind the other; a plant that has an error
/// is named, and has nothing.
template <class Of> auto ofPlants(std::uint64_t first, std::uint64_t last, const Of& of) {
  decltype(of(first)) all;
  for (std::uint64_t number = first; number <= last; ++number)
    try {
      for (auto& each : of(number))
        all.push_back(std::move(each));
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%d: %s\n", static_cast<int>(number), error.what());
    }
  return all;
}

} // namespace espalier
