#pragma once

#include <string>
#include <vector>

namespace espalier {

/// A library that the program works with.
struct Library {
  std::string name;
  std::string version; // of the one that runs; of those that are headers alone, of the one compiled
  std::string license; // by its SPDX name, where it has one
  std::string use;     // what the program has it for
};

/// All of them, as they are asked now.
[[nodiscard]] std::vector<Library> libraries();

} // namespace espalier
