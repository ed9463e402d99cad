#pragma once

#include "core/surface/envelopes/asymmetric_hull.h"

#include <map>
#include <string>
#include <vector>

namespace espalier {

/// Where a place of an envelope stands: how far out from its middle, and how high [L]. Of a center,
/// out and across are x and y.
struct HandlePlace {
  double out = 0;
  double level = 0;
  double across = 0;

  bool operator==(const HandlePlace&) const = default;
};

/// Places that were set by hand, by the names of handles.
using HandlePlaces = std::map<std::string, HandlePlace>;

/// A place of an envelope that people drag.
struct EnvelopeHandle {
  std::string name;                                // in files: "top", "ahead"
  std::string label;                               // to people
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); // [L]
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();   // of length 1: it moves along this
  /// Level, of length 1: it moves along this, too, if it is not zero.
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();
  bool isFree = false; // it moves anywhere
};

/// Of an asymmetric hull: its top and bottom, and its four widest places.
[[nodiscard]] std::vector<EnvelopeHandle> handlesOf(const AsymmetricHull& hull);

/// Where a handle comes to stand that is dragged to `place`: as near to there as it may be, so that
/// bottom, widest places and top stay above each other, and top and bottom within the widest line.
/// pre: handlesOf(hull) has one of this name
[[nodiscard]] HandlePlace draggedTo(const AsymmetricHull& hull, const std::string& name,
                                    const Eigen::Vector3d& place);

/// The hull with these handles there, others where they are. What of it could not stand so, as the
/// hull is another one than that which was dragged, gives way.
[[nodiscard]] AsymmetricHull withHandles(AsymmetricHull hull, const HandlePlaces& places);

/// The hull that an envelope was made of, by its parameters; z is up.
/// pre: it was made of one
[[nodiscard]] AsymmetricHull asymmetricHullOf(const std::vector<EnvelopeParameter>& parameters);

} // namespace espalier
