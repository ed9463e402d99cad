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

ShownMessage farNote(const PointCloud& cloud, const std::vector<Eigen::Index>& far) {
  const Eigen::AlignedBox3d plant = plantBounds(cloud);
  double farthest = 0;
  for (const Eigen::Index point : far)
    farthest = std::max(farthest, plant.exteriorDistance(cloud.position(point)));
  if (far.size() == 1)
    return {
        Shown::tr("1 point lies far from all others, %1 away: the step Clean leaves it out, and "
                  "spacing, size and view are those of the others"),
        {lengthText(farthest)}};
  return {Shown::tr("%1 points lie far from all others, up to %2 away: the step Clean leaves them "
                    "out, and spacing, size and view are those of the others"),
          {std::to_string(far.size()), lengthText(farthest)}};
}

/// "12 of 100 points ...": the numbers that such a sentence begins with.
ShownMessage shareNote(const char* sentence, std::size_t some, std::size_t all,
                       const std::string& file) {
  return {sentence, {std::to_string(some), std::to_string(all)}, FilePlace{file}};
}

} // namespace

std::vector<ShownMessage> scanNotes(const PointCloud& cloud, const std::string& name) {
  std::vector<ShownMessage> notes;
  if (const auto far = farPoints(cloud); !far.empty()) {
    notes.push_back(farNote(cloud, far));
    notes.back().where = FilePlace{name};
  }
  const auto all = static_cast<std::size_t>(cloud.size());
  const std::size_t repeated = repeatedPoints(cloud).size();
  if (repeated + 1 == all) return notes; // refused as one place
  constexpr std::size_t few = 100;       // files that overlap a little repeat some: one in so many
  if (few * repeated > all)
    notes.push_back(
        shareNote(Shown::tr("%1 of %2 points lie at the place of another: each place counts once"),
                  repeated, all, name));
  return notes;
}

std::optional<ShownMessage> leftOutNote(const PointCloud& cloud, std::size_t listed,
                                        const std::string& name) {
  const auto kept = static_cast<std::size_t>(cloud.size());
  if (kept == listed) return std::nullopt;
  return shareNote(
      Shown::tr("%1 of %2 points are not finite, or beyond any plant, and are left out"),
      listed - kept, listed, name);
}

} // namespace espalier
