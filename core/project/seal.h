#pragma once

#include "core/project/corrections.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace espalier {

/// An expert's word that a structure is right: who signed it, when, and what work went into it.
/// It holds for the structure it was given for, and for no other.
struct Seal {
  std::string author;
  std::int64_t time = 0; // [ms] since 1970-01-01 UTC
  HandWork work;
  std::size_t nodes = 0;
  double length = 0;      // [L] of all edges
  std::uint64_t hash = 0; // StructureHash of what was signed

  bool operator==(const Seal&) const = default;
};

/// @param time  now [ms] since 1970-01-01 UTC
/// @throws Error if a node is not reviewed, there is none, or `author` is blank
[[nodiscard]] Seal signedBy(const std::string& author, std::int64_t time, const History& history);

/// A JSON object with keys in snake_case, for projects and for a file beside an exported structure.
[[nodiscard]] std::string textOf(const Seal& seal);
/// @throws Error if the text is none of a seal
[[nodiscard]] Seal sealFrom(const std::string& text);

} // namespace espalier
