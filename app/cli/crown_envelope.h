#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/cloud/point_set.h"
#include "core/graph/find_root.h"
#include "core/pipeline/envelopes.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace espalier {

/// What a crown's envelope is drawn about.
struct EnvelopedPlant {
  Eigen::Matrix3Xd places;
  PlantScale scale;
  bool isOfSkeleton = false; // about nodes, not points
};

[[nodiscard]] EnvelopedPlant ofPoints(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                                      const Progress& progress);
[[nodiscard]] EnvelopedPlant ofSkeleton(const Skeleton& skeleton, UpAxis up);

/// @param settings  OPTION=VALUE of its kind
/// @param unit      of the plant: "mm"; empty: not known
/// @throws Error, WrongUsage, Cancelled
[[nodiscard]] Envelope crownEnvelope(const EnvelopedPlant& plant, const EnvelopeKind& kind,
                                     const std::vector<std::string>& settings, UpAxis up,
                                     const std::string& unit, const Progress& progress);

/// Adds an option that takes the name of a kind.
CLI::Option* addEnvelopeKind(CLI::App& command, const std::string& option, std::string& name,
                             const std::string& help);

void printEnvelope(const Envelope& envelope, const std::string& unit);

} // namespace espalier
