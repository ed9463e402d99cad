#include "core/cloud/point_set.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace espalier {
namespace {

using Run = PointSet::Run;

/// Walks along the borders of two sets, and keeps where `isKept` says so.
template <class IsKept>
std::vector<Run> combined(const std::vector<Run>& a, const std::vector<Run>& b, IsKept isKept) {
  const auto borderOf = [](const std::vector<Run>& runs, std::size_t i) {
    if (i / 2 == runs.size()) return std::numeric_limits<std::uint32_t>::max(); // never
    return i % 2 == 0 ? runs[i / 2].begin : runs[i / 2].end;
  };
  std::vector<Run> result;
  bool wasKept = false;
  std::size_t i = 0; // borders behind: odd inside of a run
  std::size_t j = 0;
  while (i < 2 * a.size() || j < 2 * b.size()) {
    const std::uint32_t at = std::min(borderOf(a, i), borderOf(b, j));
    if (i < 2 * a.size() && borderOf(a, i) == at) ++i;
    if (j < 2 * b.size() && borderOf(b, j) == at) ++j;
    const bool isNowKept = isKept(i % 2 == 1, j % 2 == 1);
    if (isNowKept == wasKept) continue;
    if (isNowKept)
      result.push_back({at, at});
    else
      result.back().end = at;
    wasKept = isNowKept;
  }
  return result;
}

template <class Values>
Values picked(const Values& values, const std::vector<Eigen::Index>& points) {
  Values result;
  if (values.empty()) return result;
  result.reserve(points.size());
  for (const Eigen::Index point : points)
    result.push_back(values[static_cast<std::size_t>(point)]);
  return result;
}

} // namespace

PointSet PointSet::of(const std::vector<Eigen::Index>& points) {
  PointSet set;
  for (const Eigen::Index point : points) {
    const auto column = static_cast<std::uint32_t>(point);
    if (!set.runs_.empty() && set.runs_.back().end == column)
      ++set.runs_.back().end;
    else
      set.runs_.push_back({column, column + 1});
  }
  return set;
}

PointSet PointSet::firstOf(Eigen::Index count) {
  PointSet set;
  if (count > 0) set.runs_.push_back({0, static_cast<std::uint32_t>(count)});
  return set;
}

std::optional<PointSet> PointSet::ofRuns(std::vector<Run> runs) {
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (runs[i].begin >= runs[i].end || (i > 0 && runs[i - 1].end >= runs[i].begin))
      return std::nullopt;
  PointSet set;
  set.runs_ = std::move(runs);
  return set;
}

std::size_t PointSet::size() const {
  std::size_t count = 0;
  for (const Run& run : runs_)
    count += run.end - run.begin;
  return count;
}

bool PointSet::contains(Eigen::Index point) const {
  const auto behind = std::ranges::upper_bound(
      runs_, point, {}, [](const Run& run) { return static_cast<Eigen::Index>(run.begin); });
  return behind != runs_.begin() && point < static_cast<Eigen::Index>(std::prev(behind)->end);
}

std::vector<Eigen::Index> PointSet::points() const {
  std::vector<Eigen::Index> result;
  result.reserve(size());
  for (const Run& run : runs_)
    for (std::uint32_t point = run.begin; point < run.end; ++point)
      result.push_back(point);
  return result;
}

PointSet PointSet::operator|(const PointSet& other) const {
  PointSet set;
  set.runs_ = combined(runs_, other.runs_, [](bool a, bool b) { return a || b; });
  return set;
}

PointSet PointSet::operator&(const PointSet& other) const {
  PointSet set;
  set.runs_ = combined(runs_, other.runs_, [](bool a, bool b) { return a && b; });
  return set;
}

PointSet PointSet::operator-(const PointSet& other) const {
  PointSet set;
  set.runs_ = combined(runs_, other.runs_, [](bool a, bool b) { return a && !b; });
  return set;
}

PointSet PointSet::operator^(const PointSet& other) const {
  PointSet set;
  set.runs_ = combined(runs_, other.runs_, [](bool a, bool b) { return a != b; });
  return set;
}

std::vector<Eigen::Index> others(const PointSet& points, Eigen::Index count) {
  return (PointSet::firstOf(count) - points).points();
}

PointCloud without(const PointCloud& cloud, const PointSet& points) {
  const std::vector<Eigen::Index> kept = others(points, cloud.size());
  return PointCloud(StoredPoints{.positions = cloud.positions()(Eigen::all, kept),
                                 .origin = cloud.origin(),
                                 .colors = picked(cloud.colors(), kept),
                                 .intensities = picked(cloud.intensities(), kept),
                                 .fileOrder = picked(cloud.fileOrder(), kept),
                                 .stations = cloud.stations(),
                                 .stationOf = picked(cloud.stationOf(), kept)});
}

} // namespace espalier
