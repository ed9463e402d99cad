#pragma once

#include "core/surface/envelopes/envelope.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace espalier {

/// An envelope as a report lists it.
struct ReportedEnvelope {
  std::string kind;          // its name
  std::string label;         // to people, in English
  bool isOfSkeleton = false; // about nodes, not points
  bool isByHand = false;     // handles of it were dragged
  bool isUsual = false; // nor options set, nor points left out: the command line makes it again
  Envelope envelope;
};

/// Keys: volume, area, height, diameter, parameters, mesh.{corners,triangles,volume,area}. Angles
/// in degrees.
[[nodiscard]] nlohmann::ordered_json numbersOf(const Envelope& envelope);

/// Keys: kind, of ("points" or "skeleton"), by_hand, and those of the envelope.
[[nodiscard]] nlohmann::ordered_json numbersOf(const ReportedEnvelope& reported);

} // namespace espalier
