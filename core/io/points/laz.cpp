#include "core/io/points/laz.h"

#include "core/base/parallel.h"
#include "core/base/shown_message.h"
#include "core/io/points/copc_octree.h"
#include "core/io/points/las_points.h"
#include "core/io/points/laz_layout.h"
#include "core/io/points/laz_points.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/range_decoder.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
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
    throw ShownError({Shown::tr("its header promises %1 points, but only %2 bytes follow: the file "
                                "is cut short or damaged, copy or export it again"),
                      {std::to_string(header.count), std::to_string(bytes)},
                      FilePlace{file}});
  checkPointCount(FilePlace{file}, header.count);
}

/// A chunk that is read, and what is known of its points.
struct PlacedChunk {
  LazChunk chunk;
  std::uint64_t place = 0; // of its first point among all points of the file
  unsigned level = 0;      // in the octree of a COPC file
};

/// The chunks in which points that are asked for may lie, in the order in which they are read: as
/// in the file, or of an octree the coarse levels first.
std::vector<PlacedChunk> chunksToRead(const LazLayout& layout, const std::vector<CopcNode>& nodes,
                                      const ReadOptions& options) {
  std::vector<PlacedChunk> chunks;
  std::uint64_t place = 0;
  for (std::size_t i = 0; i < layout.chunks.size(); ++i) {
    const LazChunk& chunk = layout.chunks[i];
    // The root shows in what numbers colors are, wherever the box is.
    const bool isAsked = nodes.empty() || nodes[i].level == 0 || !options.box ||
                         nodes[i].cube.intersects(*options.box);
    if (isAsked) chunks.push_back({chunk, place, nodes.empty() ? 0 : nodes[i].level});
    place += chunk.count;
  }
  std::ranges::stable_sort(chunks, {}, &PlacedChunk::level);
  return chunks;
}

/// Decodes chunks of a file.
class ChunkReader {
public:
  /// All must outlive the reader.
  ChunkReader(const LasHeader& header, const LazLayout& layout, const Progress& progress)
      : header_(header), layout_(layout), progress_(progress) {}

  /// @param bytes  of the chunk
  /// @return none if it is damaged
  [[nodiscard]] std::optional<std::vector<LasPoint>> pointsOf(const LazChunk& chunk,
                                                              std::string_view bytes) const {
    try {
      return decoded(chunk, bytes);
    } catch (const DamagedStream&) {
      return std::nullopt;
    }
  }

private:
  std::vector<LasPoint> decoded(const LazChunk& chunk, std::string_view rest) const {
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

  const LasHeader& header_;
  const LazLayout& layout_;
  const Progress& progress_;
};

/// The first of `chunks` that are decoded before their points are gathered: few enough to fit into
/// memory beside these, enough for all threads, and of one level.
std::span<const PlacedChunk> batchOf(std::span<const PlacedChunk> chunks) {
  constexpr std::uint64_t most = 1U << 22;
  std::uint64_t points = 0;
  std::size_t size = 0;
  for (; size < chunks.size() && points < most && chunks[size].level == chunks[0].level; ++size)
    points += chunks[size].chunk.count;
  return chunks.first(size);
}

void addChunks(std::span<const PlacedChunk> chunks, ByteSource& source, const ChunkReader& reader,
               PartChooser& chooser, LasPoints& points, const std::string& file,
               const Progress& progress) {
  std::vector<std::string> bytes;
  for (const PlacedChunk& each : chunks) {
    progress.check();
    bytes.push_back(source.read(each.chunk.start, each.chunk.size));
  }
  std::vector<std::optional<std::vector<LasPoint>>> decoded(chunks.size());
  parallelFor(
      static_cast<Eigen::Index>(chunks.size()),
      [&](Eigen::Index i) {
        const auto at = static_cast<std::size_t>(i);
        decoded[at] = reader.pointsOf(chunks[at].chunk, bytes[at]);
      },
      progress, 1);
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    progress.check();
    if (!decoded[i])
      throw ShownError({Shown::tr("its points from byte %1 on cannot be unpacked: the file is "
                                  "damaged, copy or export it again"),
                        {std::to_string(chunks[i].chunk.start)},
                        FilePlace{file}});
    chooser.goTo(chunks[i].place, chunks[i].level);
    for (const LasPoint& point : *decoded[i])
      points.add(point);
    decoded[i].reset();
  }
}

} // namespace

ImportedPoints readLaz(std::istream& in, const std::string& file, const ReadOptions& options,
                       const Progress& progress) {
  ByteSource source(in);
  const std::string head = source.read(0, longestLasHeader);
  const LasHeader header = readLasHeader(head, source.size(), file);
  if (!isLaz(head))
    throw ShownError(
        {Shown::tr("is LAS, not compressed (LAZ): name it so, as a.las"), {}, FilePlace{file}});
  checkPackedPromise(file, header, source.size() - header.pointStart);
  const LazLayout layout = readLazLayout(source, header, file);
  const std::vector<CopcNode> nodes =
      options.isPart() ? copcNodesOf(source, header, layout, file) : std::vector<CopcNode>();
  const std::vector<PlacedChunk> chunks = chunksToRead(layout, nodes, options);
  std::uint64_t expected = 0;
  for (const PlacedChunk& each : chunks)
    expected += std::min(each.chunk.count, mostPointsIn(each.chunk.size));
  PartChooser chooser(options);
  LasPoints points(header, expected, chooser);
  const ChunkReader reader(header, layout, progress);
  std::span<const PlacedChunk> rest = chunks;
  while (!rest.empty()) {
    const std::span<const PlacedChunk> batch = batchOf(rest);
    const auto done = static_cast<double>(chunks.size() - rest.size());
    const auto all = static_cast<double>(chunks.size());
    const auto size = static_cast<double>(batch.size());
    addChunks(batch, source, reader, chooser, points, file,
              progress.part(done / all, (done + size) / all));
    const unsigned level = batch.front().level;
    rest = rest.subspan(batch.size());
    const bool isLevelRead = !rest.empty() && rest.front().level > level;
    if (isLevelRead && chooser.areEnough(points.size())) break;
  }
  return std::move(points).finish(file);
}

} // namespace espalier
