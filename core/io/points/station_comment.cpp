#include "core/io/points/station_comment.h"

#include "core/base/coordinates.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <optional>

namespace espalier {
namespace {

/// Where a scanner stood by three words; none if they are no place.
std::optional<Eigen::Vector3d> scannerIn(const std::array<std::string_view, 3>& words) {
  Eigen::Vector3d place;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto number = numberIn(words[axis]);
    if (!number) return std::nullopt;
    place[static_cast<Eigen::Index>(axis)] = *number;
  }
  return isInRange(place) ? std::optional(place) : std::nullopt;
}

} // namespace

std::string stationComment(std::size_t index, const Station& station) {
  std::string text = "station " + std::to_string(index);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    text += station.scanner ? ' ' + plainDecimal((*station.scanner)[axis]) : std::string(" -");
  std::string name = ' ' + station.name;
  std::ranges::replace_if(
      name, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text + name;
}

std::vector<Station> stationsIn(std::span<const std::string_view> comments) {
  std::vector<Station> stations;
  for (std::string_view rest : comments) {
    if (nextWord(rest) != "station") continue;
    const auto index = numberIn(nextWord(rest));
    if (!index || *index != static_cast<double>(stations.size()) || stations.size() == mostStations)
      return {};
    std::array<std::string_view, 3> words;
    for (std::string_view& word : words)
      word = nextWord(rest);
    stations.push_back({.name = std::string(trimmed(rest)), .scanner = scannerIn(words)});
  }
  return stations;
}

} // namespace espalier
