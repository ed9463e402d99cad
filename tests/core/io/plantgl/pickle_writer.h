#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace espalier::test {

/// Values as Python pickles them with protocol 2.
struct PickleWriter {
  [[nodiscard]] static std::string integer(std::int64_t value);
  [[nodiscard]] static std::string real(double value);
  [[nodiscard]] static std::string text(const std::string& value);
  [[nodiscard]] static std::string vector(double x, double y, double z); // PlantGL's Vector3
};

/// The tables of OpenAlea's class MTG.
struct PickledMtg {
  std::map<std::int64_t, std::int64_t> scales;
  std::map<std::int64_t, std::int64_t> parents;
  std::map<std::int64_t, std::int64_t> complexes;
  std::map<std::int64_t, std::string> labels;
  std::map<std::int64_t, std::string> edges;
  std::map<std::int64_t, std::array<double, 3>> positions;
  std::map<std::string, std::map<std::int64_t, std::string>> extra; // pickled values
};

/// As PlantScan3D writes it.
[[nodiscard]] std::string pickled(const PickledMtg& mtg);

/// A plant P1 with a stem of three nodes, whose second bears a branch of one.
[[nodiscard]] PickledMtg pickledPlant();
[[nodiscard]] std::string bmtgFile(); // of that

} // namespace espalier::test
