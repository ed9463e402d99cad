#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/clean/ground.h"
#include "core/clean/standing_points.h"
#include "core/clean/wood_paths.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace espalier {

struct PlantsOptions {
  Length slabFrom = heights(0.015); // [L] above the ground: where stems are looked for,
  Length slabTo = heights(0.05);    // from here to here
  Length together = heights(0.04);  // [L] stems nearer than this are of one plant
  Length widestGap = heights(0.05); // [L] parts farther off than this are of no plant
  Length voxel = spacings(2);       // [L] places that paths lead over
  int neighbors = 8;                // links per place, >= 1
  WoodPathCosts costs;              // of paths, thinness in [0, 10], turn in [0, 1000]
  double leastStem = 0.15;          // of the places of the thickest stem; thinner ones are twigs
  double oneWood = 0.7;     // of the thickness of the thinner stem: wood so thick all along is one
  double leastShare = 0.02; // of the points of the greatest; smaller ones are none
  GroundOptions ground;     // what the slab is measured from
};

[[nodiscard]] PlantsOptions resolved(PlantsOptions options, const PlantScale& scale);

/// Which plant each point is of.
struct PlantParts {
  std::vector<std::uint32_t> ofPoint; // number of its plant, 0: of none
  std::vector<Eigen::Vector3d> bases; // [L] where each stands: plant n at n - 1
  std::vector<Eigen::Index> sizes;    // points in each, largest first
};

/// Cuts a plot into plants: each point goes to the stem base that it is nearest to along the
/// plants.
///
/// Stems are the parts of a slab above the ground that reach from its lower to its upper side,
/// twigs that reach into it left out. From them the cheapest paths lead over the means of cubes of
/// points, along the links of the nearest and over gaps: wood gets thinner outwards and goes on
/// straight, so thin wood and turns are dear, and a branch that a twig of another plant touches
/// stays with its own (wood_paths.h). A stem from which wood leads to a thicker one that is nowhere
/// thinner is a branch that reaches the ground; crowns touch in wood that is thinner than trunks.
///
/// @param points  3 x N, z up, of plants alone [L]
/// @param heights of the points above the ground [L]; those below zero are of no plant
/// @param bases   where plants stand [L]; none: they are looked for
/// @return plants by size, the largest first; none if no stem is found
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N).
/// Source: S. Tao et al., "Segmenting tree crowns from terrestrial and mobile LiDAR data by
/// exploring ecological theories", ISPRS J. Photogramm. 110, 2015. Differs: distances are not
/// divided by stem diameters, which for potted plants and rows are much the same; links cost by
/// the thickness of the wood and by turns.
[[nodiscard]] PlantParts plantsAmong(const Eigen::Matrix3Xf& points,
                                     const std::vector<float>& heights,
                                     const std::vector<Eigen::Vector3d>& bases,
                                     const PlantsOptions& options, const Progress& progress = {});

/// The same, of points above a ground that is known; those of the ground are of no plant.
[[nodiscard]] PlantParts plantsAbove(const GroundSurface& ground, const Eigen::Matrix3Xf& points,
                                     const std::vector<Eigen::Vector3d>& bases,
                                     const PlantsOptions& options, const Progress& progress = {});

/// The plants of a scan. The ground is looked for among all of its points, also those left out: so
/// it may be set aside before, or still be there.
/// @param bases  in the frame of the file [L]; none: they are looked for
/// @return by column of the cloud; bases in the frame of the file
/// @throws as plantsAmong()
[[nodiscard]] PlantParts plantsOf(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                                  const PlantScale& scale,
                                  const std::vector<Eigen::Vector3d>& bases = {},
                                  const PlantsOptions& options = {}, const Progress& progress = {});

} // namespace espalier
