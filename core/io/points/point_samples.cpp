#include "core/io/points/point_samples.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr std::uint64_t sampledRecords = std::uint64_t{1} << 14;
constexpr std::uint64_t recordsPerRun = 16;
constexpr std::uint64_t sampledBlocks = 256;
constexpr std::uint64_t blockBytes = 8192;
constexpr std::uint64_t smallText = std::uint64_t{1} << 22;

void takeLines(std::string_view text, const std::function<bool(std::string_view)>& take,
               LineSample& sample) {
  sample.bytes += text.size();
  LineReader lines(text);
  while (const auto line = lines.next())
    if (take(*line)) ++sample.lines;
}

} // namespace

void sampleRecords(ByteSource& source, std::uint64_t start, std::uint64_t recordSize,
                   std::uint64_t count, const std::function<void(const char*)>& take) {
  const auto takeRun = [&](std::uint64_t first, std::uint64_t length) {
    const std::string bytes = source.read(start + first * recordSize, length * recordSize);
    for (std::size_t at = 0; at + recordSize <= bytes.size(); at += recordSize)
      take(bytes.data() + at);
  };
  if (recordSize == 0 || count > source.size()) return;
  if (count <= sampledRecords) {
    for (std::uint64_t first = 0; first < count; first += recordsPerRun) // records may be long
      takeRun(first, std::min(recordsPerRun, count - first));
    return;
  }
  constexpr std::uint64_t runs = sampledRecords / recordsPerRun;
  for (std::uint64_t run = 0; run < runs; ++run)
    takeRun((count - recordsPerRun) / (runs - 1) * run, recordsPerRun);
}

std::uint64_t LineSample::linesIn(std::uint64_t allBytes) const {
  if (isAll || bytes == 0) return lines;
  return static_cast<std::uint64_t>(std::llround(
      static_cast<double>(allBytes) * static_cast<double>(lines) / static_cast<double>(bytes)));
}

LineSample sampleLines(ByteSource& source, std::uint64_t start,
                       const std::function<bool(std::string_view)>& take) {
  LineSample sample;
  const std::uint64_t size = source.size() - std::min(start, source.size());
  if (size <= smallText) {
    sample.isAll = true;
    takeLines(source.read(start, size), take, sample);
    return sample;
  }
  const std::uint64_t step = (size - blockBytes) / (sampledBlocks - 1);
  for (std::uint64_t block = 0; block < sampledBlocks; ++block) {
    const std::string bytes = source.read(start + block * step, blockBytes);
    std::string_view whole = bytes;
    if (block > 0) whole.remove_prefix(std::min(whole.find('\n'), whole.size() - 1) + 1);
    whole = whole.substr(0, whole.rfind('\n') + 1);
    takeLines(whole, take, sample);
  }
  return sample;
}

} // namespace espalier
