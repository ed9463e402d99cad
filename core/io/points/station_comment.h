#pragma once

#include "core/cloud/point_cloud.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// Stations in the comments of a file, in their order: "station 0 X Y Z name", with "- - -" where
/// it is not known where the scanner stood. A name is on one line.
[[nodiscard]] std::string stationComment(std::size_t index, const Station& station);

/// The stations that comments name; none if they are not numbered from 0 on. Others are passed
/// over.
[[nodiscard]] std::vector<Station> stationsIn(std::span<const std::string_view> comments);

} // namespace espalier
