#pragma once

#include "core/base/progress.h"
#include "core/surface/surface_mesh.h"

#include <cstddef>
#include <vector>

namespace espalier {

struct LightOptions {
  int pixels = 1024; // along the longer side of the picture of each direction, 8 to 16384
};

/// What is seen of a surface from one part of the sky.
struct DirectionalStar {
  double elevation = 0;  // [rad]
  double azimuth = 0;    // [rad]
  double weight = 0;     // of this part of the sky
  double silhouette = 0; // area of the picture, each place counted once [L^2]
  double star = 0;       // silhouette per area of the surface
};

/// The same with pictures of fewer pixels: how far the numbers may be trusted.
struct StarAtPixels {
  int pixels = 0;
  double star = 0;
};

/// How much of its surface a plant shows to the sky (silhouette to total area ratio, STAR).
struct LightInterception {
  double area = 0;                         // of the surface [L^2]
  double star = 0;                         // over the sky, weighted; 1/4 of a sphere
  std::vector<DirectionalStar> directions; // of overcastSky()
  std::vector<StarAtPixels> convergence;   // an eighth of the pixels, a quarter, half, all
};

/// STAR over the 46 directions of the standard overcast sky.
///
/// From each direction the triangles are drawn without perspective; a pixel counts if its center is
/// covered, however often, so that wood behind wood counts once and wood thinner than a pixel
/// counts right in the mean. Needs no display.
///
/// @throws Error     if the mesh has no area or a corner that is no number, or the pixels are out
///                   of range
/// @throws Cancelled if `progress` asks to stop
/// Deterministic on any number of threads. Time O(46 (triangles + covered pixels)), memory a byte
/// per pixel and thread.
/// Source: H. Sinoquet et al., "Simple equations to estimate light interception by isolated trees
/// from canopy structure features", New Phytologist 175, 2007; thesis, 5.1.2.
[[nodiscard]] LightInterception lightInterception(const SurfaceMesh& mesh,
                                                  const LightOptions& options = {},
                                                  const Progress& progress = {});

} // namespace espalier
