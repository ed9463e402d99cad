#include "app/cli/evaluate_command.h"

#include "app/cli/files.h"
#include "app/cli/plant_file.h"
#include "core/base/coordinates.h"
#include "core/evaluate/match/comparable.h"
#include "core/io/csv.h"

#include <ostream>

namespace espalier {

Skeleton skeletonIn(const std::string& file, double scale) {
  Skeleton skeleton = plantIn(file).skeleton;
  requireComparable(skeleton, file);
  if (scale != 1)
    for (const NodeId id : skeleton.ids()) {
      skeleton.setPosition(id, scale * skeleton[id].position);
      skeleton.setRadius(id, scale * skeleton[id].radius, skeleton[id].origin);
      if (!isInRange(skeleton[id].position, skeleton[id].radius))
        throw outOfRange(FilePlace{file + ", scaled: node " + std::to_string(indexOf(id))});
    }
  return skeleton;
}

void writeTable(const std::string& file, const std::vector<std::vector<std::string>>& rows) {
  writeAndReport(file, [&](std::ostream& out) {
    for (const std::vector<std::string>& row : rows)
      out << csvLine(row);
  });
}

} // namespace espalier
