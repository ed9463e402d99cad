#include "core/io/scan_notes.h"

#include "core/base/text.h"
#include "core/cloud/far_points.h"
#include "core/cloud/repeated_points.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// A distance to whole units, or to thousandths if it is short.
std::string lengthText(double length) {
  return plainDecimal(length < 100 ? std::round(length * 1000) / 1000 : std::round(length));
}

std::string farNote(const PointCloud& cloud, const std::vector<Eigen::Index>& far) {
  const Eigen::AlignedBox3d plant = plantBounds(cloud);
  double farthest = 0;
  for (const Eigen::Index point : far)
    farthest = std::max(farthest, plant.exteriorDistance(cloud.position(point)));
  const std::string away = lengthText(farthest) + " away";
  if (far.size() == 1)
    return "1 point lies far from all others, " + away +
           ": the step Clean leaves it out, and spacing, size and view are those of the others";
  return std::to_string(far.size()) + " points lie far from all others, up to " + away +
         ": the step Clean leaves them out, and spacing, size and view are those of the others";
}

} // namespace

std::vector<std::string> scanNotes(const PointCloud& cloud, const std::string& name) {
  std::vector<std::string> notes;
  if (const auto far = farPoints(cloud); !far.empty())
    notes.push_back(name + ": " + farNote(cloud, far));
  const std::size_t repeated = repeatedPoints(cloud).size();
  if (repeated + 1 == static_cast<std::size_t>(cloud.size())) return notes; // refused as one place
  constexpr std::size_t few = 100; // files that overlap a little repeat some: one in so many
  if (few * repeated > static_cast<std::size_t>(cloud.size()))
    notes.push_back(name + ": " + std::to_string(repeated) + " of " + std::to_string(cloud.size()) +
                    " points lie at the place of another: each place counts once");
  return notes;
}

std::string leftOutNote(const PointCloud& cloud, std::size_t listed, const std::string& name) {
  const auto kept = static_cast<std::size_t>(cloud.size());
  if (kept == listed) return {};
  return name + ": " + std::to_string(listed - kept) + " of " + std::to_string(listed) +
         " points are not finite, or beyond any plant, and are left out";
}

} // namespace espalier
