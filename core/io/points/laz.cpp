#include "core/io/points/laz.h"

#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/io/points/las_points.h"
#include "core/io/points/laz_layout.h"
#include "core/io/points/laz_points.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/range_decoder.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// How many points bytes can hold at most: each takes a hundredth of a bit, if it is as expected.
std::uint64_t mostPointsIn(std::uint64_t bytes) {
  return 1024 * bytes;
}

/// A small file of many equal points is refused: it would fill the memory.
void checkPackedPromise(const std::string& file, const LasHeader& header, std::size_t bytes) {
  constexpr std::uint64_t alwaysFine = 1U << 24;
  constexpr std::uint64_t fineInAByte = 32; // scans have less than one
  const std::uint64_t most = std::max(alwaysFine, fineInAByte * bytes);
  if (header.count > most)
    throw Error(file + ": its header promises " + counted(header.count, "point") + ", but only " +
                counted(bytes, "byte") +
                " follow: the file is cut short or damaged, copy or export it again");
  checkPointCount(file, header.count);
}

/// Decodes chunks of a file.
class ChunkReader {
public:
  /// All must outlive the reader.
  ChunkReader(std::string_view bytes, const LasHeader& header, const LazLayout& layout,
              const Progress& progress)
      : bytes_(bytes), header_(header), layout_(layout), progress_(progress) {}

  /// None if the chunk is damaged.
  [[nodiscard]] std::optional<std::vector<LasPoint>> pointsOf(const LazChunk& chunk) const {
    try {
      return decoded(chunk);
    } catch (const DamagedStream&) {
      return std::nullopt;
    }
  }

private:
  std::vector<LasPoint> decoded(const LazChunk& chunk) const {
    std::string_view rest = bytes_.substr(chunk.start, chunk.size);
    if (rest.size() < header_.pointLength) throw DamagedStream{};
    std::string point(rest.substr(0, header_.pointLength)); // the first lies there as it is
    rest.remove_prefix(point.size());
    std::vector<LasPoint> points;
    points.reserve(std::min(chunk.count, mostPointsIn(chunk.size)));
    points.push_back(lasPointAt(point.data(), header_));
    if (chunk.count == 1) return points;
    const auto decoder = layout_.isLayered ? layeredDecoder(rest, layout_.items, point.data())
                                           : pointwiseDecoder(rest, layout_.items, point.data());
    for (std::uint64_t i = 1; i < chunk.count; ++i) {
      if (i % 65536 == 0) progress_.check();
      decoder->next(point.data());
      points.push_back(lasPointAt(point.data(), header_));
    }
    return points;
  }

  std::string_view bytes_;
  const LasHeader& header_;
  const LazLayout& layout_;
  const Progress& progress_;
};

/// The first of `chunks` that are decoded before their points are gathered: few enough to fit into
/// memory twice, enough for all threads.
std::span<const LazChunk> batchOf(std::span<const LazChunk> chunks) {
  constexpr std::uint64_t most = 1U << 22;
  std::uint64_t points = 0;
  std::size_t size = 0;
  for (; size < chunks.size() && points < most; ++size)
    points += chunks[size].count;
  return chunks.first(size);
}

void addChunks(std::span<const LazChunk> chunks, const ChunkReader& reader, LasPoints& points,
               const std::string& file, const Progress& progress) {
  std::vector<std::optional<std::vector<LasPoint>>> decoded(chunks.size());
  parallelFor(
      static_cast<Eigen::Index>(chunks.size()),
      [&](Eigen::Index i) {
        const auto at = static_cast<std::size_t>(i);
        decoded[at] = reader.pointsOf(chunks[at]);
      },
      progress, 1);
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    progress.check();
    if (!decoded[i])
      throw Error(file + ": its points from byte " + std::to_string(chunks[i].start) +
                  " on cannot be unpacked: the file is damaged, copy or export it again");
    for (const LasPoint& point : *decoded[i])
      points.add(point);
    decoded[i].reset();
  }
}

} // namespace

Imported<RawPoints> readLaz(std::istream& in, const std::string& file, const Progress& progress) {
  const std::string bytes = readAll(in, progress.part(0, 0.1));
  const LasHeader header = readLasHeader(bytes, file);
  if (!isLaz(bytes)) throw Error(file + ": is LAS, not compressed (LAZ): name it so, as a.las");
  checkPackedPromise(file, header, bytes.size() - header.pointStart);
  const LazLayout layout = readLazLayout(bytes, header, file);
  std::uint64_t expected = 0;
  for (const LazChunk& chunk : layout.chunks)
    expected += std::min(chunk.count, mostPointsIn(chunk.size));
  LasPoints points(header, expected);
  const ChunkReader reader(bytes, header, layout, progress);
  std::span<const LazChunk> rest = layout.chunks;
  while (!rest.empty()) {
    const std::span<const LazChunk> batch = batchOf(rest);
    const auto done = static_cast<double>(layout.chunks.size() - rest.size());
    const auto all = static_cast<double>(layout.chunks.size());
    const auto size = static_cast<double>(batch.size());
    addChunks(batch, reader, points, file,
              progress.part(0.1 + 0.9 * done / all, 0.1 + 0.9 * (done + size) / all));
    rest = rest.subspan(batch.size());
  }
  return std::move(points).finish(file);
}

} // namespace espalier
