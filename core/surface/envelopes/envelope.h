#pragma once

#include "core/surface/envelopes/crown.h"
#include "core/surface/surface_mesh.h"

#include <string>
#include <vector>

namespace espalier {

/// One number of those that an envelope is made from.
struct EnvelopeParameter {
  enum class Kind { length, angle, number, coordinate }; // coordinates: x, y and z in a row
  std::string name;                                      // in files: "top_radius"
  std::string label;                                     // to people
  Kind kind = Kind::length;
  double value = 0; // [L], [rad] or none
};

/// A closed surface about a crown, z up.
struct Envelope {
  SurfaceMesh mesh;                          // closed [L]
  std::vector<EnvelopeParameter> parameters; // by which programs of others make the same
  double volume = 0;                         // [L^3], by formula where there is one
  double area = 0;                           // [L^2], likewise
  double height = 0;                         // [L]
  double diameter = 0; // of a circle as large as its convex outline from above [L]
  /// Of an ellipsoid, where to its semi-axes lie: a column of length 1 for each.
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
  /// Of an extruded or skinned hull, the lines that it is drawn by: corners in a row [L].
  std::vector<std::vector<Eigen::Vector3d>> profiles = {};
};

/// Its parameters but those that it says of itself: the height that solids are made from.
[[nodiscard]] std::vector<EnvelopeParameter> ownParameters(const Envelope& envelope);

/// Envelope with the numbers of its mesh.
[[nodiscard]] Envelope envelopeOf(SurfaceMesh mesh, std::vector<EnvelopeParameter> parameters = {});

/// A place by its three coordinates: name_x, name_y and name_z.
void addPlace(std::vector<EnvelopeParameter>& parameters, const std::string& name,
              const std::string& label, const Eigen::Vector3d& place);

/// One of the parameters, and the place of three of them. pre: they are there
[[nodiscard]] double valueOf(const std::vector<EnvelopeParameter>& parameters,
                             const std::string& name);
[[nodiscard]] Eigen::Vector3d placeOf(const std::vector<EnvelopeParameter>& parameters,
                                      const std::string& name);

/// Turns and moves the surface with its profiles, its directions and the places among its
/// parameters; azimuths stay those of a plant that stands.
void moveEnvelope(Envelope& envelope, const Eigen::Matrix3d& turn, const Eigen::Vector3d& move);

/// Which share of the points lies inside a closed mesh, in [0, 1]: by rays straight up.
/// @throws Cancelled if `progress` asks to stop
/// Time and memory O((N + triangles) sqrt(triangles)) at most.
[[nodiscard]] double shareInside(const SurfaceMesh& mesh, const Eigen::Matrix3Xd& points,
                                 const Progress& progress = {});

} // namespace espalier
