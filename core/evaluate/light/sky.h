#pragma once

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// A part of the sky, seen in one direction.
struct SkyDirection {
  double elevation;          // above the horizon [rad]
  double azimuth;            // from x, counterclockwise from above [rad], in [0, 2 pi)
  double weight;             // share of the light on level ground that comes from this part
  Eigen::Vector3d direction; // to it, length 1; up is z
};

/// The 46 parts of the standard overcast sky; their weights add up to 1.
///
/// The directions are the corners and the middles of the faces of an icosahedron that stands on a
/// corner, and two places on each edge. A weight is what the luminance (1 + 2 sin h) / 3 times
/// sin h gives over all of the sky that is nearer to this direction than to the others.
/// Sources: J. A. den Dulk, "The interpretation of remote sensing", Wageningen, 1989 (directions);
/// P. Moon, D. E. Spencer, "Illumination from a non-uniform sky", Illum. Eng. 37, 1942 (luminance).
[[nodiscard]] const std::vector<SkyDirection>& overcastSky();

} // namespace espalier
