#pragma once

#include "core/pipeline/pipeline_options.h"

#include <memory>
#include <string>
#include <vector>

namespace espalier {

// Cleaning by itself, for those who want its result.

/// What one step left out.
struct CleaningRecord {
  const Step* step = nullptr;
  const Method* method = nullptr;
  Eigen::Index leftOut = 0; // points
  std::vector<ShownMessage> notes;
};

struct CleanedScan {
  PipelineState state; // with the scale of what is left
  /// All that is left out, those at the place of such a point, too; those at the place of one that
  /// is kept are kept.
  PointSet leftOut;
  std::vector<CleaningRecord> steps; // those that are on
};

/// Runs the steps that clean.
/// @throws Error     if the cloud has fewer than 2 places, an option is unknown or out of range, or
///                   a step fails
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] CleanedScan cleanedScan(const std::shared_ptr<const PointCloud>& cloud,
                                      const PipelineOptions& options,
                                      const Progress& progress = {});

/// One plant of a plot.
struct CutPlant {
  std::vector<Eigen::Index> points;               // ascending
  Eigen::Vector3d root = Eigen::Vector3d::Zero(); // [L], frame of the file: its lowest point at the
                                                  // stem
};

struct CutPlot {
  std::vector<CutPlant> plants;      // the one of most points first
  std::vector<CleaningRecord> steps; // those before plants are cut
};

/// Cuts a plot into its plants: runs the steps before `plant`, then, with its options, cuts what is
/// left, and cleans each plant by the steps behind by its own scale. A plant of which that leaves
/// nothing is none.
/// @param bases  where plants stand [L], frame of the file; none: they are looked for
/// @throws as cleanedScan() and plantsAmong() (core/clean/plants.h); also if no plant comes of it
[[nodiscard]] CutPlot cutPlot(const std::shared_ptr<const PointCloud>& cloud,
                              const std::vector<Eigen::Vector3d>& bases,
                              const PipelineOptions& options, const Progress& progress = {});

} // namespace espalier
