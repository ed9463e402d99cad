#include "tests/core/io/points/laz_writer.h"

#include "core/base/random.h"
#include "core/io/bytes/scalar.h"
#include "core/io/points/adaptive_models.h"
#include "core/io/points/las_header.h"
#include "core/io/points/laz_layout.h"
#include "core/io/points/laz_prediction.h"
#include "tests/core/io/points/range_encoder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <optional>
#include <vector>

namespace espalier::test {
namespace {

std::uint8_t byteOf(const char* bytes) {
  return static_cast<std::uint8_t>(*bytes);
}

std::uint16_t wordOf(const char* bytes) {
  return valueAt<std::uint16_t>(bytes);
}

std::int32_t wrappedDifference(const char* now, const char* before) {
  return static_cast<std::int32_t>(valueAt<std::uint32_t>(now) - valueAt<std::uint32_t>(before));
}

/// Encodes colors as ColorDecoder reads them.
class ColorEncoder {
public:
  void next(RangeEncoder& out, const LazColor& now, const LazColor& last) {
    const auto byte = [](const LazColor& color, std::size_t channel, std::size_t half) {
      return color[channel] >> (8 * half) & 0xff;
    };
    std::uint32_t changes = now[0] == now[1] && now[0] == now[2] ? 0 : 1 << 6;
    for (std::size_t i = 0; i < 6; ++i)
      if (byte(now, i / 2, i % 2) != byte(last, i / 2, i % 2)) changes |= 1U << i;
    out.symbol(changes_, changes);
    const auto write = [&](std::size_t channel, std::size_t half, int expected) {
      const std::size_t at = 2 * channel + half;
      if ((changes >> at & 1) != 0)
        out.symbol(bytes_[at], (byte(now, channel, half) - std::clamp(expected, 0, 255)) & 0xff);
    };
    for (const std::size_t half : {0U, 1U})
      write(0, half, byte(last, 0, half));
    if ((changes & 1 << 6) == 0) return;
    for (const std::size_t half : {0U, 1U}) {
      const int red = byte(now, 0, half) - byte(last, 0, half);
      const int green = byte(now, 1, half) - byte(last, 1, half);
      write(1, half, byte(last, 1, half) + red);
      write(2, half, byte(last, 2, half) + (red + green) / 2);
    }
  }

private:
  SymbolModel changes_{128};
  SymbolModels bytes_{6, 256};
};

LazColor colorOf(const char* bytes) {
  return {wordOf(bytes), wordOf(bytes + 2), wordOf(bytes + 4)};
}

/// Encodes an item of a point by that of the point before.
class ItemEncoder {
public:
  ItemEncoder() = default;
  ItemEncoder(const ItemEncoder&) = delete;
  ItemEncoder& operator=(const ItemEncoder&) = delete;
  virtual ~ItemEncoder() = default;
  virtual void next(RangeEncoder& out, const char* now, const char* before) = 0;
};

class Point10Encoder1 : public ItemEncoder {
public:
  void next(RangeEncoder& out, const char* now, const char* before) override {
    const std::int32_t dx = wrappedDifference(now, before);
    const std::int32_t dy = wrappedDifference(now + 4, before + 4);
    dx_.next(out, median(xs_), dx);
    dy_.next(out, median(ys_), dy, std::min(dx_.differenceBits(), 19U));
    xs_ = {xs_[1], xs_[2], dx};
    ys_ = {ys_[1], ys_[2], dy};
    const std::uint32_t bits = (dx_.differenceBits() + dy_.differenceBits()) / 2;
    z_.next(out, valueAt<std::int32_t>(before + 8), valueAt<std::int32_t>(now + 8),
            std::min(bits, 19U));
    out.symbol(changes_, 63);
    intensity_.next(out, wordOf(before + 12), wordOf(now + 12));
    out.symbol(returns_[byteOf(before + 14)], byteOf(now + 14));
    out.symbol(classes_[byteOf(before + 15)], byteOf(now + 15));
    angle_.next(out, byteOf(before + 16), byteOf(now + 16), bits < 3 ? 1 : 0);
    out.symbol(userData_[byteOf(before + 17)], byteOf(now + 17));
    source_.next(out, wordOf(before + 18), wordOf(now + 18));
  }

private:
  static std::int32_t median(std::array<std::int32_t, 3> numbers) {
    std::ranges::sort(numbers);
    return numbers[1];
  }

  std::array<std::int32_t, 3> xs_{};
  std::array<std::int32_t, 3> ys_{};
  IntegerEncoder dx_{32, 1}, dy_{32, 20}, z_{32, 20}, intensity_{16, 1}, angle_{8, 2},
      source_{16, 1};
  SymbolModel changes_{64};
  SymbolModels returns_{256, 256}, classes_{256, 256}, userData_{256, 256};
};

class Point10Encoder2 : public ItemEncoder {
public:
  void next(RangeEncoder& out, const char* now, const char* before) override {
    const std::uint32_t number = byteOf(now + 14) & 7;
    const std::uint32_t returns = byteOf(now + 14) >> 3 & 7;
    const std::size_t context = returnContext(returns, number);
    const auto changed = [&](std::size_t at) { return now[at] == before[at] ? 0U : 1U; };
    const std::uint32_t changes =
        changed(14) << 5 | (wordOf(now + 12) == intensities_[context] ? 0U : 1U) << 4 |
        changed(15) << 3 | changed(16) << 2 | changed(17) << 1 | (changed(18) | changed(19));
    out.symbol(changes_, changes);
    if ((changes & 32) != 0) out.symbol(returns_[byteOf(before + 14)], byteOf(now + 14));
    if ((changes & 16) != 0)
      intensity_.next(out, intensities_[context], wordOf(now + 12),
                      std::min<std::size_t>(context, 3));
    intensities_[context] = wordOf(now + 12);
    if ((changes & 8) != 0) out.symbol(classes_[byteOf(before + 15)], byteOf(now + 15));
    if ((changes & 4) != 0)
      out.symbol(angles_[byteOf(now + 14) >> 6 & 1],
                 (byteOf(now + 16) - byteOf(before + 16)) & 255);
    if ((changes & 2) != 0) out.symbol(userData_[byteOf(before + 17)], byteOf(now + 17));
    if ((changes & 1) != 0) source_.next(out, wordOf(before + 18), wordOf(now + 18));
    const std::int32_t dx = wrappedDifference(now, before);
    const std::int32_t dy = wrappedDifference(now + 4, before + 4);
    dx_.next(out, xs_[context].value(), dx, returns == 1 ? 1 : 0);
    xs_[context].add(dx);
    dy_.next(out, ys_[context].value(), dy, axisContext(dx_.differenceBits(), 20, returns == 1));
    ys_[context].add(dy);
    std::int32_t& height = heights_[returnLevel(returns, number)];
    const std::uint32_t bits = (dx_.differenceBits() + dy_.differenceBits()) / 2;
    z_.next(out, height, valueAt<std::int32_t>(now + 8), axisContext(bits, 18, returns == 1));
    height = valueAt<std::int32_t>(now + 8);
  }

private:
  SymbolModel changes_{64};
  SymbolModels returns_{256, 256}, classes_{256, 256}, userData_{256, 256}, angles_{2, 256};
  std::array<std::uint16_t, 16> intensities_{};
  std::array<StreamedMedian, 16> xs_, ys_;
  std::array<std::int32_t, 8> heights_{};
  IntegerEncoder intensity_{16, 4}, source_{16, 1}, dx_{32, 2}, dy_{32, 22}, z_{32, 20};
};

/// Starts a sequence with each time: legal, and of no use but here.
class GpsTimeEncoder : public ItemEncoder {
public:
  void next(RangeEncoder& out, const char* now, const char* before) override {
    constexpr std::uint32_t newSequence = 2;
    out.symbol(kinds_, newSequence);
    times_.next(out, valueAt<std::int32_t>(before + 4), valueAt<std::int32_t>(now + 4), 8);
    out.bits(32, valueAt<std::uint32_t>(now));
  }

private:
  SymbolModel kinds_{6};
  IntegerEncoder times_{32, 9};
};

class Rgb12Encoder : public ItemEncoder {
public:
  void next(RangeEncoder& out, const char* now, const char* before) override {
    colors_.next(out, colorOf(now), colorOf(before));
  }

private:
  ColorEncoder colors_;
};

class BytesEncoder : public ItemEncoder {
public:
  explicit BytesEncoder(std::size_t count) : models_(count, 256), count_(count) {}
  void next(RangeEncoder& out, const char* now, const char* before) override {
    for (std::size_t i = 0; i < count_; ++i)
      out.symbol(models_[i], (byteOf(now + i) - byteOf(before + i)) & 255);
  }

private:
  SymbolModels models_;
  std::size_t count_;
};

std::unique_ptr<ItemEncoder> itemEncoder(const LazItem& item) {
  if (item.type == LazItemType::point10 && item.version == 1)
    return std::make_unique<Point10Encoder1>();
  if (item.type == LazItemType::point10) return std::make_unique<Point10Encoder2>();
  if (item.type == LazItemType::gpsTime) return std::make_unique<GpsTimeEncoder>();
  if (item.type == LazItemType::rgb12) return std::make_unique<Rgb12Encoder>();
  return std::make_unique<BytesEncoder>(item.size);
}

std::string pointwiseChunk(const std::vector<std::string>& points,
                           const std::vector<LazItem>& items) {
  std::vector<std::unique_ptr<ItemEncoder>> encoders;
  for (const LazItem& item : items)
    encoders.push_back(itemEncoder(item));
  RangeEncoder out;
  for (std::size_t i = 1; i < points.size(); ++i) {
    std::size_t at = 0;
    for (std::size_t k = 0; k < items.size(); ++k) {
      encoders[k]->next(out, points[i].data() + at, points[i - 1].data() + at);
      at += items[k].size;
    }
  }
  return points[0] + std::move(out).finish();
}

/// The models of a scanner channel, and its last point.
struct ChannelModels {
  std::string last;
  bool hasNewTime = false;
  std::array<StreamedMedian, 12> xs, ys;
  std::array<std::int32_t, 8> heights{};
  std::array<std::uint16_t, 8> intensities{};
  SymbolModels changes{8, 128}, returns{16, 16}, numbers{16, 16}, flags{64, 64};
  SymbolModel channelSteps{3}, numberSteps{13};
  IntegerEncoder dx{32, 2}, dy{32, 22}, z{32, 20}, intensity{16, 4};

  explicit ChannelModels(const std::string& point) : last(point) {
    heights.fill(valueAt<std::int32_t>(point.data() + 8));
    intensities.fill(wordOf(point.data() + 12));
  }
  [[nodiscard]] std::uint32_t number() const { return byteOf(last.data() + 14) & 15; }
  [[nodiscard]] std::uint32_t returnCount() const { return byteOf(last.data() + 14) >> 4; }
  [[nodiscard]] std::size_t kind() const {
    return (number() == 1 ? 1 : 0) + (number() >= returnCount() ? 2 : 0);
  }
};

class LayeredEncoder {
public:
  LayeredEncoder(const std::string& first, bool hasColors, int version)
      : hasColors_(hasColors), version_(version), channel_(channelOf(first)) {
    channels_[channel_].emplace(first);
    colorChannel_ = channel_;
    if (hasColors) colors_[channel_].emplace(ColorChannel{colorOf(first.data() + 30), {}});
  }

  void next(const std::string& point) {
    nextShared(point);
    ChannelModels& channel = *channels_[channel_];
    const auto flags = [](const std::string& of) {
      return (byteOf(of.data() + 15) & 15) | (byteOf(of.data() + 15) >> 6) << 4;
    };
    flags_.symbol(channel.flags[static_cast<std::size_t>(flags(channel.last))],
                  static_cast<std::uint32_t>(flags(point)));
    channel.last = point;
    std::uint16_t& intensity =
        channel.intensities[2 * channel.kind() + (channel.hasNewTime ? 1 : 0)];
    channel.intensity.next(intensity_, intensity, wordOf(point.data() + 12), channel.kind());
    intensity = wordOf(point.data() + 12);
    if (hasColors_) nextColor(colorOf(point.data() + 30));
  }

  /// Of point14 and of the colors.
  std::vector<std::string> layers() && {
    const std::string passedOver = "not a layer";
    std::vector<std::string> all(9, passedOver);
    all[0] = std::move(xy_).finish();
    all[1] = std::move(z_).finish();
    all[3] = std::move(flags_).finish();
    all[4] = std::move(intensity_).finish();
    all[5] = "";
    if (hasColors_) all.push_back(std::move(rgb_).finish());
    return all;
  }

private:
  struct ColorChannel {
    LazColor last{};
    ColorEncoder colors;
  };

  static std::size_t channelOf(const std::string& point) {
    return byteOf(point.data() + 15) >> 4 & 3;
  }

  /// What is in the first two layers.
  void nextShared(const std::string& point) {
    ChannelModels* channel = &*channels_[channel_];
    const std::size_t to = channelOf(point);
    const std::size_t context = channel->kind() + (channel->hasNewTime ? 4 : 0);
    const ChannelModels& base = channels_[to] ? *channels_[to] : *channel;
    const std::uint32_t number = byteOf(point.data() + 14) & 15;
    const std::uint32_t returns = byteOf(point.data() + 14) >> 4;
    const std::uint32_t step = (number - base.number()) & 15;
    const bool hasNewTime = point.substr(22, 8) != base.last.substr(22, 8);
    const std::uint32_t numberChange = step == 15 ? 2 : step < 2 ? step : 3;
    xy_.symbol(channel->changes[context], (to != channel_ ? 64U : 0U) | (hasNewTime ? 16U : 0U) |
                                              (returns != base.returnCount() ? 4U : 0U) |
                                              numberChange);
    if (to != channel_) {
      xy_.symbol(channel->channelSteps, static_cast<std::uint32_t>((to - channel_ - 1) & 3));
      if (!channels_[to]) channels_[to].emplace(channel->last);
      channel_ = to;
      channel = &*channels_[to];
    }
    channel->hasNewTime = hasNewTime;
    if (returns != channel->returnCount())
      xy_.symbol(channel->returns[channel->returnCount()], returns);
    if (numberChange == 3 && hasNewTime) xy_.symbol(channel->numbers[channel->number()], number);
    if (numberChange == 3 && !hasNewTime) xy_.symbol(channel->numberSteps, step - 2);
    nextPosition(point, *channel, returns, number);
  }

  void nextPosition(const std::string& point, ChannelModels& channel, std::uint32_t returns,
                    std::uint32_t number) {
    const bool isSingle = returns == 1;
    const std::size_t context =
        2 * layeredReturnContext(returns, number) + (channel.hasNewTime ? 1 : 0);
    const std::int32_t dx = wrappedDifference(point.data(), channel.last.data());
    const std::int32_t dy = wrappedDifference(point.data() + 4, channel.last.data() + 4);
    channel.dx.next(xy_, channel.xs[context].value(), dx, isSingle ? 1 : 0);
    channel.xs[context].add(dx);
    channel.dy.next(xy_, channel.ys[context].value(), dy,
                    axisContext(channel.dx.differenceBits(), 20, isSingle));
    channel.ys[context].add(dy);
    const std::uint32_t bits = (channel.dx.differenceBits() + channel.dy.differenceBits()) / 2;
    std::int32_t& height = channel.heights[returnLevel(returns, number)];
    channel.z.next(z_, height, valueAt<std::int32_t>(point.data() + 8),
                   axisContext(bits, 18, isSingle));
    height = valueAt<std::int32_t>(point.data() + 8);
  }

  /// In version 3 with its odd choice of the color to compare with: see LayeredColors.
  void nextColor(const LazColor& color) {
    std::size_t compared = colorChannel_;
    if (!colors_[channel_]) {
      colors_[channel_].emplace(ColorChannel{colors_[compared]->last, {}});
      compared = channel_;
    } else if (version_ == 4) {
      compared = channel_;
    }
    colorChannel_ = channel_;
    colors_[channel_]->colors.next(rgb_, color, colors_[compared]->last);
    colors_[compared]->last = color;
  }

  bool hasColors_;
  int version_;
  std::size_t channel_;
  std::size_t colorChannel_;
  std::array<std::optional<ChannelModels>, 4> channels_;
  std::array<std::optional<ColorChannel>, 4> colors_;
  RangeEncoder xy_, z_, flags_, intensity_, rgb_;
};

std::string layeredChunk(const std::vector<std::string>& points,
                         const std::vector<LazItem>& items) {
  const bool hasColors = items.size() > 1 && items[1].type != LazItemType::bytes14;
  LayeredEncoder encoder(points[0], hasColors, items[0].version);
  for (std::size_t i = 1; i < points.size(); ++i)
    encoder.next(points[i]);
  std::vector<std::string> layers = std::move(encoder).layers();
  std::size_t others = items.back().type == LazItemType::bytes14 ? items.back().size : 0;
  if (hasColors && items[1].type == LazItemType::rgbNir14) ++others;
  layers.insert(layers.end(), others, "?");
  std::string chunk = points[0];
  appendValue(chunk, static_cast<std::uint32_t>(points.size()));
  for (const std::string& layer : layers)
    appendValue(chunk, static_cast<std::uint32_t>(layer.size()));
  for (const std::string& layer : layers)
    chunk += layer;
  return chunk;
}

std::vector<LazItem> itemsFor(const LasHeader& header, int version) {
  using enum LazItemType;
  const auto number = static_cast<std::uint16_t>(version);
  std::vector<LazItem> items;
  std::size_t size = 0;
  const auto add = [&](LazItemType type, std::size_t length) {
    items.push_back({type, static_cast<std::uint16_t>(length), number});
    size += length;
  };
  if (header.format < 6) {
    add(point10, 20);
    if (header.format == 1 || header.format == 3) add(gpsTime, 8);
    if (header.format >= 2) add(rgb12, 6);
  } else {
    add(point14, 30);
    if (header.format == 7) add(rgb14, 6);
    if (header.format == 8) add(rgbNir14, 8);
  }
  if (header.pointLength > size)
    add(header.format < 6 ? bytes : bytes14, header.pointLength - size);
  return items;
}

std::string lazRecord(const std::vector<LazItem>& items, std::uint16_t compressor,
                      std::uint32_t chunkSize) {
  std::string record;
  appendValue(record, compressor);
  appendValue(record, std::uint16_t{0}); // coder
  appendValue(record, std::uint32_t{3}); // version of the writer
  appendValue(record, std::uint32_t{0}); // options
  appendValue(record, chunkSize);
  appendValue(record, std::int64_t{-1});
  appendValue(record, std::int64_t{-1});
  appendValue(record, static_cast<std::uint16_t>(items.size()));
  for (const LazItem& item : items) {
    appendValue(record, static_cast<std::uint16_t>(item.type));
    appendValue(record, item.size);
    appendValue(record, item.version);
  }
  std::string header("\0\0laszip encoded\0\0", 18);
  appendValue(header, std::uint16_t{22204});
  appendValue(header, static_cast<std::uint16_t>(record.size()));
  header.resize(54);
  return header + record;
}

struct PackedChunk {
  std::string bytes;
  std::size_t points;
};

std::string chunkTable(const std::vector<PackedChunk>& chunks, bool hasCounts) {
  std::string table;
  appendValue(table, std::uint32_t{0}); // version
  appendValue(table, static_cast<std::uint32_t>(chunks.size()));
  if (chunks.empty()) return table;
  RangeEncoder out;
  IntegerEncoder numbers(32, 2);
  std::int32_t count = 0;
  std::int32_t size = 0;
  for (const PackedChunk& chunk : chunks) {
    if (hasCounts) numbers.next(out, count, static_cast<std::int32_t>(chunk.points), 0);
    numbers.next(out, size, static_cast<std::int32_t>(chunk.bytes.size()), 1);
    count = static_cast<std::int32_t>(chunk.points);
    size = static_cast<std::int32_t>(chunk.bytes.size());
  }
  return table + std::move(out).finish();
}

std::vector<std::string> pointsIn(const std::string& las, const LasHeader& header) {
  std::vector<std::string> points;
  for (std::uint64_t i = 0; i < header.count; ++i)
    points.push_back(las.substr(header.pointStart + i * header.pointLength, header.pointLength));
  return points;
}

} // namespace

std::string lazFile(const std::string& las, const LazForm& form) {
  const LasHeader header = readLasHeader(las, "sample");
  const bool isLayered = header.format >= 6;
  const int version = form.version > 0 ? form.version : isLayered ? 3 : 2;
  const std::vector<LazItem> items = itemsFor(header, version);
  const std::vector<std::string> points = pointsIn(las, header);
  std::vector<PackedChunk> chunks;
  std::size_t size = form.chunkSize > 0 ? form.chunkSize : points.size();
  for (std::size_t i = 0; i < points.size(); i += chunks.back().points) {
    if (form.hasChunksOfAnySize && i > 0) ++size;
    const std::vector<std::string> part(
        points.begin() + static_cast<std::ptrdiff_t>(i),
        points.begin() + static_cast<std::ptrdiff_t>(std::min(i + size, points.size())));
    chunks.push_back(
        {isLayered ? layeredChunk(part, items) : pointwiseChunk(part, items), part.size()});
  }
  const bool hasTable = form.chunkSize > 0;
  std::string file = las.substr(0, header.size);
  file += lazRecord(items,
                    isLayered  ? 3
                    : hasTable ? 2
                               : 1,
                    form.hasChunksOfAnySize ? 0xffffffff : form.chunkSize);
  setValueAt(file.data() + 96, static_cast<std::uint32_t>(file.size()));
  setValueAt(file.data() + 100, std::uint32_t{1});
  file[104] = static_cast<char>(byteOf(file.data() + 104) | 0x80);
  const std::size_t start = file.size();
  if (hasTable) appendValue(file, std::int64_t{-1});
  for (const PackedChunk& chunk : chunks)
    file += chunk.bytes;
  if (!hasTable) return file;
  const auto tableStart = static_cast<std::int64_t>(file.size());
  if (!form.hasTableAtEnd) setValueAt(file.data() + start, tableStart);
  file += chunkTable(chunks, form.hasChunksOfAnySize);
  if (form.hasTableAtEnd) appendValue(file, tableStart);
  return file;
}

std::string withNoise(std::string las, std::uint64_t seed) {
  const LasHeader header = readLasHeader(las, "sample");
  Random random(seed);
  std::array<std::uint32_t, 3> position{1000, 2000, 3000}; // may wrap around
  for (std::uint64_t i = 0; i < header.count; ++i) {
    char* point = las.data() + header.pointStart + i * header.pointLength;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t reach = 1U << random.below(31); // steps of all sizes
      position[axis] += static_cast<std::uint32_t>(random.below(2 * reach)) - reach;
      setValueAt(point + 4 * axis, position[axis]);
    }
    for (std::size_t at = 12; at < header.pointLength; ++at)
      if (random.below(3) > 0) point[at] = static_cast<char>(random.below(256));
    if (header.format >= 6 && random.below(2) > 0) point[15] &= 0x4f; // mostly in channel 0
    if (const std::size_t start = header.colorStart(); start > 0 && random.below(4) == 0)
      std::copy_n("grgrgr", 6, point + start);
  }
  return las;
}

} // namespace espalier::test
