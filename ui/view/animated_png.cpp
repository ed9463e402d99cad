#include "ui/view/animated_png.h"

#include "ui/view/picture.h"

#include <QtEndian>

#include <ostream>
#include <utility>
#include <vector>
#include <zlib.h>

namespace espalier {
namespace {

constexpr qsizetype signatureSize = 8;

QByteArray number(std::uint32_t value) {
  QByteArray bytes(4, 0);
  qToBigEndian(value, bytes.data());
  return bytes;
}

QByteArray number(std::uint16_t value) {
  QByteArray bytes(2, 0);
  qToBigEndian(value, bytes.data());
  return bytes;
}

void writeChunk(std::ostream& out, const QByteArray& type, const QByteArray& data) {
  const QByteArray summed = type + data;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(summed.constData()),
                         static_cast<uInt>(summed.size()));
  const QByteArray all = number(static_cast<std::uint32_t>(data.size())) + summed +
                         number(static_cast<std::uint32_t>(sum));
  out.write(all.constData(), all.size());
}

struct Chunk {
  QByteArray type;
  QByteArray data;
};

std::vector<Chunk> chunksOf(const QByteArray& png) {
  std::vector<Chunk> chunks;
  for (qsizetype at = signatureSize; at + 12 <= png.size();) {
    const auto size = static_cast<qsizetype>(qFromBigEndian<std::uint32_t>(png.constData() + at));
    chunks.push_back({png.mid(at + 4, 4), png.mid(at + 8, size)});
    at += 12 + size;
  }
  return chunks;
}

} // namespace

/// How long the picture that follows is shown.
void AnimatedPng::writeControl(const QSize& size) {
  const QByteArray place(8, 0);  // at the left, at the top
  const QByteArray asItIs(2, 0); // nothing is blended, nothing is cleared
  writeChunk(out_, "fcTL",
             number(sequence_++) + number(static_cast<std::uint32_t>(size.width())) +
                 number(static_cast<std::uint32_t>(size.height())) + place +
                 number(std::uint16_t{1}) + number(perSecond_) + asItIs);
}

void AnimatedPng::add(const QImage& frame) {
  const QByteArray png = pngOf(frame.convertToFormat(QImage::Format_RGB888)); // one head for all
  const bool isFirst = added_++ == 0;
  if (isFirst) out_.write(png.constData(), signatureSize);
  bool isBegun = false;
  for (const Chunk& chunk : chunksOf(png)) {
    if (chunk.type == "IHDR" && isFirst) {
      writeChunk(out_, chunk.type, chunk.data);
      writeChunk(out_, "acTL", number(frames_) + number(std::uint32_t{0})); // 0: without end
    } else if (chunk.type == "IDAT") {
      if (!std::exchange(isBegun, true)) writeControl(frame.size());
      if (isFirst)
        writeChunk(out_, chunk.type, chunk.data);
      else
        writeChunk(out_, "fdAT", number(sequence_++) + chunk.data);
    }
  }
  if (added_ == frames_) writeChunk(out_, "IEND", {});
}

} // namespace espalier
