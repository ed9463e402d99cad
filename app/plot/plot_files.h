#pragma once

#include "core/base/progress.h"
#include "core/pipeline/cleaned_scan.h"

#include <filesystem>
#include <string>
#include <vector>

namespace espalier {

/// Where the plants of a plot are written, and what is known of them.
struct PlotFiles {
  std::filesystem::path folder; // made if there is none
  std::string name;             // of the plot: that of a plant is "pines_03"
  std::string unit;             // of the projects, as "mm"; empty: not known
  UpAxis up = UpAxis::z;        // of the plot
};

/// A plant of a plot, as it was written.
struct PlantFile {
  std::filesystem::path project; // beside its scan of the same name
  Eigen::Index points = 0;
};

/// The list of plants in the folder, as `espalier batch` reads it.
[[nodiscard]] std::filesystem::path plantList(const PlotFiles& files);

/// Writes each plant as a scan, with colors and intensities, and as a project of it with its root,
/// and the list of all. They appear together at the end, or none does.
/// @throws Error     if the folder cannot be written to, or has a file of such a name: no file is
///                   replaced
/// @throws Cancelled if `progress` asks to stop
/// Time O(points), of which there is one copy for each plant in turn.
std::vector<PlantFile> writePlot(const PointCloud& cloud, const std::vector<CutPlant>& plants,
                                 const PlotFiles& files, const Progress& progress = {});

} // namespace espalier
