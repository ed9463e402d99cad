#pragma once

#include "core/pipeline/registry.h"

#include <functional>
#include <string>
#include <vector>

namespace espalier {

/// One value per option of a method, in order.
using Values = std::vector<double>;

/// The method "none" of a step that may be left out.
[[nodiscard]] Method noMethod(std::string help);
[[nodiscard]] bool isNoMethod(const Method& method); // it is that one

// Options that several methods have.
[[nodiscard]] Option
linksOption(const char* help = Shown::tr("Links per point along which distances are measured."));
[[nodiscard]] Option linksOverGapsOption(); // of methods of the skeleton
[[nodiscard]] Option linkKindOption();
[[nodiscard]] Option densityMeasureOption();
[[nodiscard]] Option widestGapOption();
[[nodiscard]] Option thickWoodOption();
[[nodiscard]] Option coverageOption(); // of cylinder fits
[[nodiscard]] Option cylinderLengthOption();

/// The points that cleaning kept, ascending.
[[nodiscard]] std::vector<Eigen::Index> keptPoints(const PipelineState& state);

/// The same, of those at one place the first alone: where files of a scan overlap, points lie
/// twice. Recognized where they follow each other, as they do in a cloud.
[[nodiscard]] std::vector<Eigen::Index> keptPlaces(const PipelineState& state);

/// Where the points that were kept are in the scan, about the origin of the cloud [L].
[[nodiscard]] Eigen::Matrix3Xf keptPositions(const PipelineState& state);

/// Moves the points at the place of one that was kept to where that one is now.
void followKept(Eigen::Matrix3Xf& places, const PipelineState& state);

/// @throws Error if they are too few for a plant
void requirePlant(const std::vector<Eigen::Index>& kept);

/// Makes the skeleton of the kept places as they were contracted, with the root among them.
/// `reconstruct` gives it in their frame; it ends up in that of the file.
/// @throws Error if the points are too few; whatever `reconstruct` throws
void reconstructKept(
    PipelineState& state,
    const std::function<Skeleton(const Eigen::Matrix3Xf& points, Eigen::Index root)>& reconstruct);

/// Normalized densities of points as they were scanned, in [0, 1]: contraction, which heaps points
/// up, does not count.
[[nodiscard]] std::vector<float> scannedDensities(const SpatialIndex& scanned,
                                                  DensityMeasure measure, const Progress& progress);

/// An index of these points as they were scanned: that of the whole scan, if it is at hand and they
/// are all of it.
[[nodiscard]] std::shared_ptr<const SpatialIndex>
scannedIndex(const PipelineState& state, const std::vector<Eigen::Index>& points,
             const Progress& progress);

} // namespace espalier
