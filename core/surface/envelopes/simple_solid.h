#pragma once

#include "core/surface/envelopes/envelope_handles.h"

#include <array>

namespace espalier {

/// The solids that a few lengths make, by what can be dragged of them. All but ball and ellipsoid
/// are upright.
struct SimpleSolid {
  enum class Kind { ball, ellipsoid, cylinder, cone, frustum, paraboloid, box };
  Kind kind = Kind::ball;
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); // [L], of an upright one x and y alone
  double bottom = 0;                                // z [L], of an upright one
  double top = 0;                                   // likewise
  /// How far it reaches: its radius; its three semi-axes; its radii at foot and top; or half its
  /// length and width [L].
  std::array<double, 3> reaches{};
  /// Where to, columns of length 1: along x for a radius, along its semi-axes, or along length and
  /// width.
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
};

/// The solid that an envelope was made of, by its parameters; z is up. pre: it was made of one
[[nodiscard]] SimpleSolid simpleSolidOf(SimpleSolid::Kind kind, const Envelope& envelope);
[[nodiscard]] Envelope envelopeOf(const SimpleSolid& solid);

/// Its center, how far it reaches, and of an upright one its top and bottom.
[[nodiscard]] std::vector<EnvelopeHandle> handlesOf(const SimpleSolid& solid);

/// Where a handle comes to stand that is dragged to `place`: as near to there as it may be, so that
/// the solid fills some space.
/// pre: handlesOf(solid) has one of this name
[[nodiscard]] HandlePlace draggedTo(const SimpleSolid& solid, const std::string& name,
                                    const Eigen::Vector3d& place);

/// The solid with these handles there, others where they are.
[[nodiscard]] SimpleSolid withHandles(SimpleSolid solid, const HandlePlaces& places);

} // namespace espalier
