#include "core/io/bytes/scalar.h"
#include "core/io/points/adaptive_models.h"
#include "core/io/points/integer_decoder.h"
#include "core/io/points/laz_points.h"
#include "core/io/points/laz_prediction.h"
#include "core/io/points/range_decoder.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace espalier {
namespace {

/// Decodes an item of points, of which `item` holds the bytes of the point before.
class ItemDecoder {
public:
  ItemDecoder() = default;
  ItemDecoder(const ItemDecoder&) = delete;
  ItemDecoder& operator=(const ItemDecoder&) = delete;
  virtual ~ItemDecoder() = default;
  virtual void next(RangeDecoder& in, char* item) = 0;
};

// Where fields lie in a point of formats 0 to 5.
constexpr std::size_t intensityAt = 12;
constexpr std::size_t returnsAt = 14; // number, count, scan direction and edge, in bits
constexpr std::size_t classAt = 15;
constexpr std::size_t angleAt = 16;
constexpr std::size_t userDataAt = 17;
constexpr std::size_t sourceAt = 18;

std::uint8_t byteAt(const char* bytes) {
  return static_cast<std::uint8_t>(*bytes);
}

void addTo(char* coordinate, std::int32_t difference) { // may wrap around
  setValueAt(coordinate,
             valueAt<std::uint32_t>(coordinate) + static_cast<std::uint32_t>(difference));
}

/// A byte that is coded in the context of its value before.
class ByteByLast {
public:
  void next(RangeDecoder& in, char* byte) {
    *byte = static_cast<char>(in.symbol(models_[byteAt(byte)]));
  }

private:
  SymbolModels models_{256, 256};
};

/// The fields of a point that both versions code alike, if they changed.
struct PlainFields {
  ByteByLast returns;
  ByteByLast classes;
  ByteByLast userData;
  IntegerDecoder source{16, 1};

  void nextSource(RangeDecoder& in, char* item) {
    const std::int32_t last = valueAt<std::uint16_t>(item + sourceAt);
    setValueAt(item + sourceAt, static_cast<std::uint16_t>(source.next(in, last)));
  }
};

/// The last three differences across an axis.
class LastThree {
public:
  [[nodiscard]] std::int32_t median() const {
    const auto [a, b, c] = last_;
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
  }
  void add(std::int32_t number) { last_ = {last_[1], last_[2], number}; }

private:
  std::array<std::int32_t, 3> last_{};
};

class Point10Version1 : public ItemDecoder {
public:
  void next(RangeDecoder& in, char* item) override {
    const std::int32_t dx = dx_.next(in, xDifferences_.median());
    xDifferences_.add(dx);
    addTo(item, dx);
    const std::int32_t dy =
        dy_.next(in, yDifferences_.median(), std::min(dx_.differenceBits(), mostBits));
    yDifferences_.add(dy);
    addTo(item + 4, dy);
    const std::uint32_t bits = (dx_.differenceBits() + dy_.differenceBits()) / 2;
    setValueAt(item + 8, z_.next(in, valueAt<std::int32_t>(item + 8), std::min(bits, mostBits)));
    nextFields(in, item, bits);
  }

private:
  static constexpr std::uint32_t mostBits = 19;

  void nextFields(RangeDecoder& in, char* item, std::uint32_t bits) {
    const std::uint32_t changes = in.symbol(changes_);
    if ((changes & 32) != 0) {
      const std::int32_t last = valueAt<std::uint16_t>(item + intensityAt);
      setValueAt(item + intensityAt, static_cast<std::uint16_t>(intensity_.next(in, last)));
    }
    if ((changes & 16) != 0) fields_.returns.next(in, item + returnsAt);
    if ((changes & 8) != 0) fields_.classes.next(in, item + classAt);
    if ((changes & 4) != 0)
      item[angleAt] = static_cast<char>(angle_.next(in, byteAt(item + angleAt), bits < 3 ? 1 : 0));
    if ((changes & 2) != 0) fields_.userData.next(in, item + userDataAt);
    if ((changes & 1) != 0) fields_.nextSource(in, item);
  }

  LastThree xDifferences_;
  LastThree yDifferences_;
  IntegerDecoder dx_{32, 1};
  IntegerDecoder dy_{32, mostBits + 1};
  IntegerDecoder z_{32, mostBits + 1};
  SymbolModel changes_{64};
  IntegerDecoder intensity_{16, 1};
  IntegerDecoder angle_{8, 2};
  PlainFields fields_;
};

class Point10Version2 : public ItemDecoder {
public:
  void next(RangeDecoder& in, char* item) override {
    const std::uint32_t changes = in.symbol(changes_);
    if ((changes & 32) != 0) fields_.returns.next(in, item + returnsAt);
    const std::uint32_t number = byteAt(item + returnsAt) & 7;
    const std::uint32_t returns = byteAt(item + returnsAt) >> 3 & 7;
    const std::size_t context = returnContext(returns, number);
    std::uint16_t& intensity = lastIntensities_[context];
    if ((changes & 16) != 0)
      intensity = static_cast<std::uint16_t>(
          intensity_.next(in, intensity, std::min<std::size_t>(context, 3)));
    setValueAt(item + intensityAt, intensity);
    nextFields(in, item, changes);
    nextPosition(in, item, context, returns, number);
  }

private:
  void nextFields(RangeDecoder& in, char* item, std::uint32_t changes) {
    if ((changes & 8) != 0) fields_.classes.next(in, item + classAt);
    if ((changes & 4) != 0) {
      const std::size_t direction = byteAt(item + returnsAt) >> 6 & 1;
      item[angleAt] = static_cast<char>(byteAt(item + angleAt) + in.symbol(angles_[direction]));
    }
    if ((changes & 2) != 0) fields_.userData.next(in, item + userDataAt);
    if ((changes & 1) != 0) fields_.nextSource(in, item);
  }

  void nextPosition(RangeDecoder& in, char* item, std::size_t context, std::uint32_t returns,
                    std::uint32_t number) {
    const bool isSingle = returns == 1;
    const std::int32_t dx = dx_.next(in, xDifferences_[context].value(), isSingle ? 1 : 0);
    xDifferences_[context].add(dx);
    addTo(item, dx);
    const std::int32_t dy = dy_.next(in, yDifferences_[context].value(),
                                     axisContext(dx_.differenceBits(), 20, isSingle));
    yDifferences_[context].add(dy);
    addTo(item + 4, dy);
    const std::uint32_t bits = (dx_.differenceBits() + dy_.differenceBits()) / 2;
    std::int32_t& height = lastHeights_[returnLevel(returns, number)];
    height = z_.next(in, height, axisContext(bits, 18, isSingle));
    setValueAt(item + 8, height);
  }

  SymbolModel changes_{64};
  PlainFields fields_;
  SymbolModels angles_{2, 256};
  std::array<std::uint16_t, 16> lastIntensities_{}; // by context, as the next two
  std::array<StreamedMedian, 16> xDifferences_;
  std::array<StreamedMedian, 16> yDifferences_;
  std::array<std::int32_t, 8> lastHeights_{}; // by level
  IntegerDecoder intensity_{16, 4};
  IntegerDecoder dx_{32, 2};
  IntegerDecoder dy_{32, 22};
  IntegerDecoder z_{32, 20};
};

/// Times come in up to four sequences, of flight lines that were merged. A time is the one before
/// in its sequence and about a multiple of their usual difference.
class GpsTimeVersion2 : public ItemDecoder {
public:
  explicit GpsTimeVersion2(const char* first) {
    sequences_[0].time = valueAt<std::uint64_t>(first);
  }

  void next(RangeDecoder& in, char* item) override {
    while (!isRead(in)) {
    }
    setValueAt(item, sequences_[current_].time);
  }

private:
  static constexpr std::uint32_t mostTimes = 500;     // the largest multiple
  static constexpr std::uint32_t mostTimesBack = 510; // stands for -10, the smallest
  static constexpr std::uint32_t sameTime = 511;
  static constexpr std::uint32_t newSequence = 512; // and above: another of the sequences

  struct Sequence {
    std::uint64_t time = 0;      // bits of a double
    std::int32_t difference = 0; // the usual one; 0: not known
    int extremes = 0;            // since a multiple that was not at an end of the range
  };

  /// Whether the time is there: a symbol may say that it is of another sequence.
  bool isRead(RangeDecoder& in) {
    Sequence& sequence = sequences_[current_];
    const bool isKnown = sequence.difference != 0;
    const std::uint32_t symbol = in.symbol(isKnown ? multiples_ : kinds_);
    const std::uint32_t start = isKnown ? newSequence : 2;
    if (symbol > start) {
      current_ = (current_ + symbol - start) % sequences_.size();
      return false;
    }
    if (symbol == start) {
      startSequence(in);
    } else if (isKnown && symbol < sameTime) {
      sequence.time += static_cast<std::uint64_t>(multiple(in, sequence, symbol));
    } else if (!isKnown && symbol == 1) {
      sequence.difference = times_.next(in, 0, 0);
      sequence.time += static_cast<std::uint64_t>(sequence.difference);
      sequence.extremes = 0;
    }
    return true;
  }

  void startSequence(RangeDecoder& in) {
    const auto lastHigh = static_cast<std::int32_t>(sequences_[current_].time >> 32);
    newest_ = (newest_ + 1) % sequences_.size();
    const auto high = static_cast<std::uint32_t>(times_.next(in, lastHigh, 8));
    sequences_[newest_] = {std::uint64_t{high} << 32 | in.bits(32), 0, 0};
    current_ = newest_;
  }

  static std::size_t contextOf(std::uint32_t symbol) {
    if (symbol == 0) return 7;
    if (symbol == 1) return 1;
    if (symbol < mostTimes) return symbol < 10 ? 2 : 3;
    if (symbol == mostTimes) return 4;
    return symbol < mostTimesBack ? 5 : 6;
  }

  /// The difference from the last time.
  std::int32_t multiple(RangeDecoder& in, Sequence& sequence, std::uint32_t symbol) {
    const std::uint32_t times = symbol <= mostTimes ? symbol : mostTimes - symbol; // may be below 0
    const auto expected = static_cast<std::int32_t>(
        times * static_cast<std::uint32_t>(sequence.difference)); // may wrap around
    const std::int32_t difference = times_.next(in, expected, contextOf(symbol));
    if (symbol == 1) sequence.extremes = 0;
    if (symbol == 0 || symbol == mostTimes || symbol == mostTimesBack) {
      ++sequence.extremes;
      if (sequence.extremes > 3) {
        sequence.difference = difference;
        sequence.extremes = 0;
      }
    }
    return difference;
  }

  std::array<Sequence, 4> sequences_;
  std::size_t current_ = 0;
  std::size_t newest_ = 0;
  SymbolModel kinds_{6};
  SymbolModel multiples_{516};
  IntegerDecoder times_{32, 9};
};

class Rgb12Version2 : public ItemDecoder {
public:
  void next(RangeDecoder& in, char* item) override {
    LazColor color{};
    for (std::size_t i = 0; i < color.size(); ++i)
      color[i] = valueAt<std::uint16_t>(item + 2 * i);
    color = colors_.next(in, color);
    for (std::size_t i = 0; i < color.size(); ++i)
      setValueAt(item + 2 * i, color[i]);
  }

private:
  ColorDecoder colors_;
};

class ExtraBytes : public ItemDecoder {
public:
  explicit ExtraBytes(std::size_t count) : count_(count), models_(count, 256) {}

  void next(RangeDecoder& in, char* item) override {
    for (std::size_t i = 0; i < count_; ++i)
      item[i] = static_cast<char>(byteAt(item + i) + in.symbol(models_[i]));
  }

private:
  std::size_t count_;
  SymbolModels models_;
};

std::unique_ptr<ItemDecoder> itemDecoder(const LazItem& item, const char* first) {
  switch (item.type) {
  case LazItemType::point10:
    if (item.version == 1) return std::make_unique<Point10Version1>();
    return std::make_unique<Point10Version2>();
  case LazItemType::gpsTime:
    return std::make_unique<GpsTimeVersion2>(first);
  case LazItemType::rgb12:
    return std::make_unique<Rgb12Version2>();
  default: // all others are refused, or of layered files
    return std::make_unique<ExtraBytes>(item.size);
  }
}

class PointwiseDecoder : public LazDecoder {
public:
  PointwiseDecoder(std::string_view bytes, const std::vector<LazItem>& items, const char* first)
      : in_(bytes) {
    for (const LazItem& item : items) {
      parts_.push_back({itemDecoder(item, first), item.size});
      first += item.size;
    }
  }

  void next(char* point) override {
    for (const Part& part : parts_) {
      part.decoder->next(in_, point);
      point += part.size;
    }
  }

private:
  struct Part {
    std::unique_ptr<ItemDecoder> decoder;
    std::size_t size;
  };

  RangeDecoder in_;
  std::vector<Part> parts_;
};

} // namespace

std::unique_ptr<LazDecoder> pointwiseDecoder(std::string_view bytes,
                                             const std::vector<LazItem>& items, const char* first) {
  return std::make_unique<PointwiseDecoder>(bytes, items, first);
}

} // namespace espalier
