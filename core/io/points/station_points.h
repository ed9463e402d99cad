#pragma once

#include "core/base/imported.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/part_chooser.h"

#include <cstdint>
#include <string>
#include <vector>

namespace espalier {

/// Joins the points that a scanner measured from several places, its stations.
class StationPoints {
public:
  /// @param chooser  says which points are kept; must outlive this
  explicit StationPoints(PartChooser& chooser) : chooser_(chooser) {}

  /// Adds the points of the next station, in the frame that all share.
  /// @param ranks    of these points, as PointCollector gives them
  /// @param station  where the scanner stood in that frame; without a name it is numbered
  void add(RawPoints points, const std::vector<std::uint64_t>& ranks, Station station);

  /// All points, station after station. Colors and intensities that some stations lack are black
  /// and 0 there; those that no station has, or that are 0 everywhere, are left out. Stations
  /// without points are not listed; over 65536 are not kept apart.
  /// @return with notes on how many stations there were, and on what some of them lack
  [[nodiscard]] Imported<RawPoints> finish(const std::string& file) &&;

private:
  void reduce();

  PartChooser& chooser_;
  RawPoints all_;
  std::vector<std::uint64_t> ranks_; // of all, if there is a limit to their number
  std::vector<Station> named_;       // those with points
  std::size_t stations_ = 0;
  std::size_t uncolored_ = 0; // stations with points, but without colors
  std::size_t unintense_ = 0; // the same, of intensities
};

} // namespace espalier
