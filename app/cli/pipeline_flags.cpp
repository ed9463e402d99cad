#include "app/cli/pipeline_flags.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/pipeline/preset.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>

namespace espalier {

struct Threads::Limit {
  std::optional<ThreadLimit> tbb;
};

Threads::Threads(int threads) : limit_(std::make_unique<Limit>()) {
  if (threads > 0) limit_->tbb.emplace(threads);
}
Threads::~Threads() = default;

void addThreadsFlag(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Use at most this many threads (default: all)")
      ->check(CLI::Range(1, 1024));
}

Eigen::Vector3d parsePlace(const std::string& text, const std::string& flag) {
  Eigen::Vector3d place;
  const char* at = text.data();
  const char* end = at + text.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto [next, error] = std::from_chars(at, end, place[axis]);
    const bool isLast = axis == 2;
    const bool endsWell = isLast ? next == end : next != end && *next == ',';
    if (error != std::errc() || !endsWell || !std::isfinite(place[axis]))
      throw Error(flag + " " + text + ": write three numbers as X,Y,Z");
    at = next + (isLast ? 0 : 1);
  }
  return place;
}

void PipelineFlags::addTo(CLI::App& command) {
  command.add_option("scan", scan, "Points of one plant: PLY, XYZ, LAS, PCD ...")->required();
  command.add_option("-o,--output", output, "File to write")->required();
  command.add_option("--method", method, "Method of the main step (see: espalier methods)");
  command.add_option("--set", settings, "STEP.OPTION=VALUE; lengths in the unit of the scan")
      ->take_all();
  command.add_option("--preset", preset, "JSON file of steps and options");
  command.add_option("--root", root, "Foot of the plant: lowest, or a place X,Y,Z")
      ->capture_default_str();
  command.add_option("--up", up, "Axis that points up")
      ->check(CLI::IsMember({"x", "y", "z"}))
      ->capture_default_str();
  command.add_option("--unit", unit, "Unit of the scan, for the statistics")
      ->check(CLI::IsMember({"mm", "cm", "m"}));
  command.add_option("--json", json, "File for statistics and the options used");
  addThreadsFlag(command, threads);
}

PipelineOptions PipelineFlags::options(const std::string& stepOfMethod) const {
  PipelineOptions result;
  if (!preset.empty()) {
    std::ifstream in(preset);
    if (!in) throw Error(preset + ": cannot be read; check the path");
    try {
      result = readPreset(in);
    } catch (const Error& error) {
      throw Error(preset + ": " + error.what());
    }
  }
  if (!method.empty()) result.set(stepOfMethod + ".method=" + method);
  for (const std::string& setting : settings)
    result.set(setting);
  if (root != "lowest") result.root = parsePlace(root, "--root");
  result.up =
      std::map<std::string, UpAxis>{{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}}.at(up);
  return result;
}

} // namespace espalier
