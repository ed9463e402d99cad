#include "tests/core/io/points/laz_chunk_encoders.h"

#include <array>
#include <bit>
#include <memory>

namespace espalier::test {
namespace {

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

} // namespace

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

} // namespace espalier::test
