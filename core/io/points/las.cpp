#include "core/io/points/las.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/points/las_points.h"
#include "core/io/points/point_collector.h"

#include <utility>

namespace espalier {

Imported<RawPoints> readLas(std::istream& in, const std::string& file, const Progress& progress) {
  const std::string bytes = readAll(in, progress.part(0, 0.3));
  const LasHeader header = readLasHeader(bytes, file);
  if (isLaz(bytes)) throw Error(file + ": is compressed (LAZ), not LAS: name it so, as a.laz");
  checkPromise(file, header.count, header.pointLength, bytes.size() - header.pointStart);
  LasPoints points(header, header.count);
  const char* point = bytes.data() + header.pointStart;
  for (std::uint64_t i = 0; i < header.count; ++i, point += header.pointLength) {
    if (i % 65536 == 0)
      progress.update(0.3 + 0.7 * static_cast<double>(i) / static_cast<double>(header.count));
    points.add(lasPointAt(point, header));
  }
  return std::move(points).finish(file);
}

} // namespace espalier
