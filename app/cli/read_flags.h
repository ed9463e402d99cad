#pragma once

#include "core/io/formats.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>

namespace CLI {
class App;
}

namespace espalier {

/// The flags that say which points of a scan are read, and how.
struct ReadFlags {
  std::uint64_t most = 0; // 0: all
  std::string box;        // empty: wherever they lie
  std::string columns;    // of a text file; empty: found out

  void addTo(CLI::App& command);

  /// @throws WrongUsage naming the flag, what it holds and what it may hold
  [[nodiscard]] ReadOptions options() const;
};

/// Of a file that is no scan. @throws Error if any of the flags is given
void requireNoneOf(const ReadFlags& flags, const std::string& file, const std::string& what);

/// Keys: points_in_file, most, box.{minimum,maximum}; null if all points were read.
[[nodiscard]] nlohmann::ordered_json partInfo(const ReadOptions& options,
                                              const ImportedCloud& scan);

} // namespace espalier
