#pragma once

#include "core/io/points/read_options.h"

#include <cstdint>
#include <string>

namespace espalier {

/// So many points of a file are opened without a question, unless its user says otherwise.
inline constexpr std::uint64_t mostPointsAtOnce = 20'000'000;

/// What of a file a scan is, and how it was read.
struct ScanPart {
  ReadOptions reading;
  std::uint64_t listed = 0; // points of the file; 0: the scan is all of it

  [[nodiscard]] bool isPart() const { return listed > 0; }
};

/// The name by which projects keep it.
inline const std::string scanPartName = "scan_part";

/// As projects keep it, so that they find the same points again; empty if the scan is whole and its
/// columns are those that are found out.
[[nodiscard]] std::string textOf(const ScanPart& part);

/// @throws Error if the text is not as textOf() writes it
[[nodiscard]] ScanPart scanPartIn(const std::string& text);

} // namespace espalier
