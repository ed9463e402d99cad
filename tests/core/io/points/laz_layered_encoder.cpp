#include "tests/core/io/points/laz_chunk_encoders.h"

#include <array>
#include <optional>
#include <utility>

namespace espalier::test {
namespace {

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

} // namespace

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

} // namespace espalier::test
