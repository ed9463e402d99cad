#pragma once

#include <cstdint>
#include <limits>

namespace espalier {

/// How the radius of a node came to be.
enum class RadiusSource : std::uint8_t {
  unknown,      // it is from a file, or there is none
  extrapolated, // from what the node carries, or from other nodes
  corrected,    // from points, changed by what it carries or by how such radii err
  measured,     // from points alone, or nearly
  byHand
};

/// Where a radius is from, and how far it can be trusted. Files of others have no place for it.
struct RadiusOrigin {
  RadiusSource source = RadiusSource::unknown;
  /// The true radius lies between these shares of the radius with a probability of 90 %, and is
  /// as often below as above; 0: not known.
  float least = 0;
  float most = 0;

  [[nodiscard]] bool hasInterval() const { return most > 0; }
  [[nodiscard]] bool isSound() const {
    return least >= 0 && most >= least && most <= std::numeric_limits<float>::max();
  }
  bool operator==(const RadiusOrigin&) const = default;
};

} // namespace espalier
