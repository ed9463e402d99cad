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

/// The values of the options of a kind.
/// @param settings  OPTION=VALUE
/// @param unit      of the plant: "mm"; empty: not known
/// @throws WrongUsage
[[nodiscard]] std::vector<double> valuesSet(const EnvelopeKind& kind,
                                            const std::vector<std::string>& settings,
                                            const EnvelopedPlant& plant, const std::string& unit);

/// Adds an option that takes the name of a kind.
CLI::Option* addEnvelopeKind(CLI::App& command, const std::string& option, std::string& name,
                             const std::string& help);

void printEnvelope(const Envelope& envelope, const std::string& unit);

} // namespace espalier
