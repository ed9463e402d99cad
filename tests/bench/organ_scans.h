#pragma once

#include "core/cloud/organ.h"
#include "core/cloud/point_cloud.h"
#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace espalier {

/// A simulated scan of a plant with or without leaves, and what each of its points lies on.
struct OrganScan {
  std::string kind;
  std::shared_ptr<const PointCloud> cloud;
  std::vector<Organ> organs;   // by point of the cloud
  double pointsPerSegment = 0; // of its wood
  Skeleton truth;              // of herbs and grasses with petioles and the midribs of leaves
};

/// Trees and shrubs bare and in leaf, conifers bare and with needles, herbs with simple and with
/// compound leaves, and grasses with long leaves, from 1 to 8 stations, with noise up to 1 / 500 of
/// their extent.
///
/// The same for the same number.
[[nodiscard]] OrganScan organScan(std::uint64_t number);

} // namespace espalier
