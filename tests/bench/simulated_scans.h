#pragma once

#include "core/cloud/point_cloud.h"
#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace espalier {

/// A simulated scan and the plant that it is of.
struct ScannedPlant {
  std::string name;
  Skeleton truth;
  std::shared_ptr<const PointCloud> cloud;
  double pointsPerSegment = 0;   // of the truth
  bool isLeafy = false;          // a herb with few large leaves, whose midribs are in the truth
  double foliage = 0;            // 1 is as dense as the kind of plant bears it
  double noise = 0;              // standard deviation along beams [L]
  std::vector<double> diameters; // of the wood at each point that is on some [L]
};

/// A plant of any kind, scanned in any way: 8 to 600 points a segment, herbs to 10 000, from 1 to 8
/// stations, with noise up to 1 / 500 of its extent, with foliage or without, whole or behind
/// leaves; one in seven is a herb with few large leaves, whose midribs are axes of it. Two in seven
/// are structures that people measured, where the shared data has them, the others grown.
///
/// The same for the same number and data.
[[nodiscard]] ScannedPlant scannedPlant(std::uint64_t number);

/// The same kinds, grown or measured, scanned more densely, with foliage or without: 400 to 8000
/// points a segment, herbs to 40 000, 250 000 at most.
[[nodiscard]] ScannedPlant densePlant(std::uint64_t number);

/// The same kinds, grown or measured, scanned densely with wide noise: 100 to 1000 points a
/// segment, herbs to 10 000, 100 000 at most, with noise from 1 / 2000 to 1 / 200 of the extent, of
/// herbs from 1 / 1000 to 1 / 60, bare but for the large leaves of some herbs.
[[nodiscard]] ScannedPlant noisyPlant(std::uint64_t number);

} // namespace espalier
