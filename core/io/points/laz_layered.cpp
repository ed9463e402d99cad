#include "core/io/bytes/scalar.h"
#include "core/io/points/adaptive_models.h"
#include "core/io/points/integer_decoder.h"
#include "core/io/points/laz_points.h"
#include "core/io/points/laz_prediction.h"
#include "core/io/points/range_decoder.h"

#include <algorithm>
#include <array>
#include <optional>

namespace espalier {
namespace {

/// What is decoded of a point of formats 6 to 10.
struct LayeredPoint {
  std::uint32_t x = 0; // may wrap around
  std::uint32_t y = 0;
  std::int32_t z = 0;
  std::uint16_t intensity = 0;
  std::uint32_t number = 0;  // of the return
  std::uint32_t returns = 0; // of the pulse
  std::uint32_t flags = 0;   // 4 bits of classification, then scan direction and edge
  bool hasNewTime = false;   // another than the point before
};

std::size_t channelOf(const char* point) {
  return static_cast<std::uint8_t>(point[15]) >> 4 & 3;
}

LayeredPoint layeredPointAt(const char* bytes) {
  const auto returns = valueAt<std::uint8_t>(bytes + 14);
  const auto flags = valueAt<std::uint8_t>(bytes + 15);
  LayeredPoint point;
  point.x = valueAt<std::uint32_t>(bytes);
  point.y = valueAt<std::uint32_t>(bytes + 4);
  point.z = valueAt<std::int32_t>(bytes + 8);
  point.intensity = valueAt<std::uint16_t>(bytes + 12);
  point.number = returns & 15;
  point.returns = returns >> 4;
  point.flags = (flags & 15) | (flags >> 6) << 4;
  return point;
}

void writePoint(const LayeredPoint& point, std::size_t channel, char* bytes) {
  setValueAt(bytes, point.x);
  setValueAt(bytes + 4, point.y);
  setValueAt(bytes + 8, point.z);
  setValueAt(bytes + 12, point.intensity);
  setValueAt(bytes + 14, static_cast<std::uint8_t>(point.number | point.returns << 4));
  setValueAt(bytes + 15, static_cast<std::uint8_t>((point.flags & 15) | channel << 4 |
                                                   (point.flags >> 4) << 6));
}

/// The models of a scanner channel, and its last point.
struct ScannerChannel {
  explicit ScannerChannel(const LayeredPoint& point) : last(point) {
    last.hasNewTime = false;
    heights.fill(point.z);
    intensities.fill(point.intensity);
  }

  LayeredPoint last;
  std::array<StreamedMedian, 12> xDifferences;
  std::array<StreamedMedian, 12> yDifferences;
  std::array<std::int32_t, 8> heights{};      // the last, by level
  std::array<std::uint16_t, 8> intensities{}; // the last, by context
  SymbolModels changes{8, 128};
  SymbolModel channelSteps{3};
  SymbolModels returns{16, 16};
  SymbolModels numbers{16, 16};
  SymbolModel numberSteps{13};
  IntegerDecoder dx{32, 2};
  IntegerDecoder dy{32, 22};
  IntegerDecoder z{32, 20};
  SymbolModels flags{64, 64};
  IntegerDecoder intensity{16, 4};
};

/// 1 for the first return of a pulse, 2 for the last, 3 for the only one.
std::size_t returnKind(const LayeredPoint& point) {
  return (point.number == 1 ? 1 : 0) + (point.number >= point.returns ? 2 : 0);
}

// Which fields changed, in the first symbol of a point. The lowest two bits are of the number of
// the return: 1, it is one more; 2, one less; 3, another.
constexpr std::uint32_t returnsChange = 1 << 2;
constexpr std::uint32_t timeChanges = 1 << 4;
constexpr std::uint32_t channelChanges = 1 << 6;

void nextReturns(RangeDecoder& in, ScannerChannel& channel, std::uint32_t changes) {
  LayeredPoint& point = channel.last;
  const std::uint32_t lastNumber = point.number;
  if ((changes & returnsChange) != 0) point.returns = in.symbol(channel.returns[point.returns]);
  switch (changes & 3) {
  case 0:
    break;
  case 1:
    point.number = (lastNumber + 1) % 16;
    break;
  case 2:
    point.number = (lastNumber + 15) % 16;
    break;
  default:
    point.number = point.hasNewTime ? in.symbol(channel.numbers[lastNumber])
                                    : (lastNumber + 2 + in.symbol(channel.numberSteps)) % 16;
  }
}

/// @param z  none: heights do not change in this chunk
void nextPosition(RangeDecoder& xy, std::optional<RangeDecoder>& z, ScannerChannel& channel) {
  LayeredPoint& point = channel.last;
  const bool isSingle = point.returns == 1;
  const std::size_t context =
      2 * layeredReturnContext(point.returns, point.number) + (point.hasNewTime ? 1 : 0);
  const std::int32_t dx =
      channel.dx.next(xy, channel.xDifferences[context].value(), isSingle ? 1 : 0);
  channel.xDifferences[context].add(dx);
  point.x += static_cast<std::uint32_t>(dx);
  const std::int32_t dy = channel.dy.next(xy, channel.yDifferences[context].value(),
                                          axisContext(channel.dx.differenceBits(), 20, isSingle));
  channel.yDifferences[context].add(dy);
  point.y += static_cast<std::uint32_t>(dy);
  if (!z) return;
  const std::uint32_t bits = (channel.dx.differenceBits() + channel.dy.differenceBits()) / 2;
  std::int32_t& height = channel.heights[returnLevel(point.returns, point.number)];
  height = channel.z.next(*z, height, axisContext(bits, 18, isSingle));
  point.z = height;
}

void nextIntensity(RangeDecoder& in, ScannerChannel& channel) {
  LayeredPoint& point = channel.last;
  const std::size_t kind = returnKind(point);
  std::uint16_t& last = channel.intensities[2 * kind + (point.hasNewTime ? 1 : 0)];
  last = static_cast<std::uint16_t>(channel.intensity.next(in, last, kind));
  point.intensity = last;
}

/// The colors of a chunk, by scanner channel.
class LayeredColors {
public:
  LayeredColors(RangeDecoder in, int version, const LazColor& first, std::size_t channel)
      : in_(in), version_(version), channel_(channel) {
    channels_[channel].emplace().last = first;
  }

  LazColor next(std::size_t channel) {
    // Version 3 compares a point that changes the channel with the color before it, and keeps it
    // as that channel's, unless the channel is new.
    std::size_t compared = channel_;
    channel_ = channel;
    if (!channels_[channel])
      channels_[channel].emplace().last = channels_[compared]->last;
    else if (version_ == 3)
      return channels_[compared]->last = decoded(compared);
    return channels_[channel]->last = decoded(channel);
  }

private:
  struct Channel {
    LazColor last{};
    ColorDecoder colors;
  };

  LazColor decoded(std::size_t compared) {
    return channels_[channel_]->colors.next(in_, channels_[compared]->last);
  }

  RangeDecoder in_;
  int version_;
  std::size_t channel_;
  std::array<std::optional<Channel>, 4> channels_;
};

constexpr std::size_t pointLayers = 9; // of item point14

std::size_t layersOf(const LazItem& item) {
  using enum LazItemType;
  if (item.type == point14) return pointLayers;
  if (item.type == rgbNir14) return 2;
  return item.type == bytes14 ? item.size : 1;
}

/// The layers of a chunk: after the number of its points comes the size of each, then all of them.
std::vector<std::string_view> layersIn(std::string_view bytes, const std::vector<LazItem>& items) {
  std::size_t count = 0;
  for (const LazItem& item : items)
    count += layersOf(item);
  constexpr std::size_t sizesStart = 4;
  if (bytes.size() < sizesStart + 4 * count) throw DamagedStream{};
  std::vector<std::string_view> layers;
  std::string_view rest = bytes.substr(sizesStart + 4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto size = valueAt<std::uint32_t>(bytes.data() + sizesStart + 4 * i);
    if (size > rest.size()) throw DamagedStream{};
    layers.push_back(rest.substr(0, size));
    rest.remove_prefix(size);
  }
  return layers;
}

/// None of an empty layer: its field is the same in all points.
std::optional<RangeDecoder> layerDecoder(std::string_view layer) {
  if (layer.empty()) return std::nullopt;
  return RangeDecoder(layer);
}

class LayeredDecoder : public LazDecoder {
public:
  LayeredDecoder(const std::vector<std::string_view>& layers, const std::vector<LazItem>& items,
                 const char* first)
      : xy_(layers[0]), z_(layerDecoder(layers[1])), flags_(layerDecoder(layers[3])),
        intensity_(layerDecoder(layers[4])), channel_(channelOf(first)) {
    channels_[channel_].emplace(layeredPointAt(first));
    const bool hasColors = items.size() > 1 && (items[1].type == LazItemType::rgb14 ||
                                                items[1].type == LazItemType::rgbNir14);
    if (!hasColors || layers[pointLayers].empty()) return;
    LazColor color{};
    for (std::size_t i = 0; i < color.size(); ++i)
      color[i] = valueAt<std::uint16_t>(first + colorStart + 2 * i);
    colors_.emplace(RangeDecoder(layers[pointLayers]), items[1].version, color, channel_);
  }

  void next(char* point) override {
    ScannerChannel* channel = &*channels_[channel_];
    const std::size_t context = returnKind(channel->last) + (channel->last.hasNewTime ? 4 : 0);
    const std::uint32_t changes = xy_.symbol(channel->changes[context]);
    if ((changes & channelChanges) != 0) channel = &nextChannel(*channel);
    channel->last.hasNewTime = (changes & timeChanges) != 0;
    nextReturns(xy_, *channel, changes);
    nextPosition(xy_, z_, *channel);
    if (flags_) channel->last.flags = flags_->symbol(channel->flags[channel->last.flags]);
    if (intensity_) nextIntensity(*intensity_, *channel);
    writePoint(channel->last, channel_, point);
    if (!colors_) return;
    const LazColor color = colors_->next(channel_);
    for (std::size_t i = 0; i < color.size(); ++i)
      setValueAt(point + colorStart + 2 * i, color[i]);
  }

private:
  static constexpr std::size_t colorStart = 30;

  /// A channel that comes first has the last point of the one before.
  ScannerChannel& nextChannel(ScannerChannel& last) {
    channel_ = (channel_ + 1 + xy_.symbol(last.channelSteps)) % channels_.size();
    if (!channels_[channel_]) channels_[channel_].emplace(last.last);
    return *channels_[channel_];
  }

  RangeDecoder xy_; // and channels, returns, and what changes
  std::optional<RangeDecoder> z_;
  std::optional<RangeDecoder> flags_;
  std::optional<RangeDecoder> intensity_;
  std::optional<LayeredColors> colors_;
  std::size_t channel_;
  std::array<std::optional<ScannerChannel>, 4> channels_;
};

} // namespace

std::unique_ptr<LazDecoder> layeredDecoder(std::string_view bytes,
                                           const std::vector<LazItem>& items, const char* first) {
  return std::make_unique<LayeredDecoder>(layersIn(bytes, items), items, first);
}

} // namespace espalier
