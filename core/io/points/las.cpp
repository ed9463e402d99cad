#include "core/io/points/las.h"

#include "core/base/shown_message.h"
#include "core/io/bytes/byte_stream.h"
#include "core/io/points/las_points.h"
#include "core/io/points/point_collector.h"

#include <utility>

namespace espalier {

ImportedPoints readLas(std::istream& in, const std::string& file, const ReadOptions& options,
                       const Progress& progress) {
  ByteSource source(in);
  const std::string head = source.read(0, longestLasHeader);
  const LasHeader header = readLasHeader(head, source.size(), file);
  if (isLaz(head))
    throw ShownError(
        {Shown::tr("is compressed (LAZ), not LAS: name it so, as a.laz"), {}, FilePlace{file}});
  checkPromise(FilePlace{file}, header.count, header.pointLength,
               source.size() - header.pointStart);
  PartChooser chooser(options);
  LasPoints points(header, header.count, chooser);
  ByteStream bytes(source, header.pointStart);
  for (std::uint64_t i = 0; i < header.count; ++i) {
    if (i % 65536 == 0) progress.update(static_cast<double>(i) / static_cast<double>(header.count));
    const char* point = bytes.take(header.pointLength);
    if (point == nullptr) throw becameShorter(file);
    points.add(lasPointAt(point, header));
  }
  return std::move(points).finish(file);
}

} // namespace espalier
