#pragma once

#include "core/simulate/habit.h"
#include "core/simulate/wood.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// Small organs of one kind on the youngest wood. Extent: the larger of height and width of the
/// plant.
struct OrganHabit {
  double spacing = 0;   // along the wood, in extents, >= 0; 0: there are none
  double length = 0.01; // in extents, in (0, 1]; each is 0.7 to 1.3 times as long
  double width = 0;     // in extents, in [0, 1]; of short shoots, which have a radius, none
  double angle = 0.8;   // with the wood, to its tip [rad], in [0, pi]
  double reach = 0.1; // they stand on wood nearer than this to its farthest apex, in extents, >= 0
};

/// What stands on the shoots of a plant and is in its scan, but no part of its structure.
struct Foliage {
  OrganHabit shortShoots = {}; // rods, as thick as the thinnest wood; they bear leaves, too
  OrganHabit blades = {};      // needles and leaves, flat
  bool areNeedles = false;
  double petiole = 0; // of a leaf, in lengths of its blade, in [0, 10]; 0: its blade stands on wood
  int leaflets = 0;   // pairs along the petiole of a compound leaf, in [0, 100]
  double droop = 0;   // how far a long blade bends to the ground along its length [rad], in [0, 4]
};

/// Foliage as a kind of plant bears it: needles on conifers; on trees and shrubs short shoots and
/// the few leaves of winter; leaves on herbs.
/// @param density  times as many organs, >= 0; 0: none
[[nodiscard]] Foliage foliageOf(Architecture architecture, double density = 1);

/// A needle or a leaf, or a part of a long one: flat, widest at the middle of its length.
struct Blade {
  Eigen::Vector3d base;  // [L], on what bears it
  Eigen::Vector3d along; // [L], from there to its tip
  Eigen::Vector3d half;  // [L], across, from its middle line to its edge where it is widest
  double atBase = 0;     // how wide it is there, of its widest; a leaf by itself is a lozenge
  double atTip = 0;
  Organ organ = Organ::blade;
};

/// Where a ray meets a blade, from either side.
[[nodiscard]] std::optional<WoodHit> hit(const Blade& blade, const Ray& ray);

[[nodiscard]] Eigen::AlignedBox3d boundsOf(const Blade& blade); // [L]

struct Organs {
  std::vector<EdgeSolid> shortShoots; // of no node
  std::vector<EdgeSolid> petioles;    // likewise
  std::vector<Blade> blades;
};

/// The organs of a plant: strewn by chance along the wood that bears them, all around it.
///
/// @param plant   with radii
/// @param extent  [L] of the plant
/// @throws Error if an option is out of its range, or these are more than 10 million organs
/// Deterministic. Time O(nodes + organs).
[[nodiscard]] Organs organsOf(const Skeleton& plant, const Foliage& foliage, double extent,
                              std::uint64_t seed);

} // namespace espalier
