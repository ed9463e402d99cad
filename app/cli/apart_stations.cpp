#include "app/cli/apart_stations.h"

#include "app/cli/arguments.h"
#include "app/cli/files.h"
#include "core/base/coordinates.h"
#include "core/base/text.h"
#include "core/cloud/joined_clouds.h"
#include "core/io/csv.h"

#include <Eigen/Geometry>

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <ostream>
#include <utility>

namespace espalier {
namespace {

std::string stationFile(const std::string& prefix, std::size_t station) {
  return prefix + '_' + std::to_string(station + 1) + ".ply";
}

std::string targetsFile(const std::string& prefix) {
  return prefix + "_pairs.csv";
}

/// The motion into the frame of a displaced station.
Eigen::Isometry3d motionInto(const Displacement& displacement, const Eigen::Vector3d& middle) {
  return Eigen::Translation3d(middle + displacement.shift * Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(displacement.angle, Eigen::Vector3d::UnitZ()) *
         Eigen::Translation3d(-middle);
}

/// Four targets about the plant, as each displaced station and the first one measure them.
void writeTargets(std::ostream& out, const std::string& prefix, std::size_t stations,
                  const Eigen::AlignedBox3d& bounds, const Eigen::Isometry3d& motion) {
  out << csvLine({"scan", "x", "y", "z", "fixed_x", "fixed_y", "fixed_z"});
  for (std::size_t station = 1; station < stations; ++station)
    for (const int corner : {0, 3, 5, 6}) { // of the box of the plant: a tetrahedron
      const Eigen::Vector3d fixed =
          bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
      std::vector<std::string> fields{
          std::filesystem::path(stationFile(prefix, station)).filename().string()};
      for (const Eigen::Vector3d& place : {Eigen::Vector3d(motion * fixed), fixed})
        for (const double coordinate : place)
          fields.push_back(plainDecimal(coordinate));
      out << csvLine(fields);
    }
}

} // namespace

Displacement displacementIn(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto shift = numberIn(text.substr(0, comma));
  const auto degrees = comma == std::string::npos ? std::nullopt : numberIn(text.substr(comma + 1));
  if (!shift || !degrees || !(std::abs(*shift) <= largestCoordinate) ||
      !(std::abs(*degrees) <= 360))
    throw WrongUsage("--apart " + inQuotes(text) +
                     ": write a length and an angle from -360 to 360 as SHIFT,DEGREES, such as "
                     "0.3,10");
  return {*shift, *degrees * std::numbers::pi / 180};
}

std::vector<std::string> filesApart(const std::string& prefix, std::size_t stations) {
  std::vector<std::string> files;
  for (std::size_t i = 0; i < stations; ++i)
    files.push_back(stationFile(prefix, i));
  files.push_back(targetsFile(prefix));
  return files;
}

void writeApart(const std::string& prefix, const SimulatedScan& scan,
                const Displacement& displacement, const Progress& progress) {
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& position : scan.points.positions)
    bounds.extend(position);
  const Eigen::Isometry3d motion = motionInto(displacement, bounds.center());
  std::vector<PointCloud> clouds;
  for (RawPoints& points : pointsByStation(scan)) {
    const auto cloud = std::make_shared<const PointCloud>(std::move(points));
    if (cloud->isEmpty())
      throw Error("station " + std::to_string(clouds.size() + 1) +
                  " sees no point: ask for more of them");
    clouds.push_back(joined({{.cloud = cloud,
                              .motion = clouds.empty() ? Eigen::Isometry3d::Identity() : motion,
                              .name = {}}}));
  }
  for (std::size_t i = 0; i < clouds.size(); ++i)
    writeAndReport(stationFile(prefix, i), clouds[i], clouds[i].positions(), progress);
  writeAndReport(targetsFile(prefix), [&](std::ostream& out) {
    writeTargets(out, prefix, clouds.size(), bounds, motion);
  });
}

} // namespace espalier
