#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// How likely a bit is 0, learned from the bits before.
class BitModel {
public:
  static constexpr int shareBits = 13;

  [[nodiscard]] std::uint32_t zeroShare() const { return zeroShare_; } // of 2^shareBits
  void learn(bool bit);

private:
  std::uint32_t zeros_ = 1;
  std::uint32_t all_ = 2;
  std::uint32_t zeroShare_ = 1U << (shareBits - 1);
  std::uint32_t cycle_ = 4; // bits from one update to the next
  std::uint32_t left_ = 4;
};

/// How likely each of some symbols is, learned from the symbols before.
class SymbolModel {
public:
  static constexpr int shareBits = 15;

  explicit SymbolModel(std::uint32_t symbols); // pre: 2 <= symbols <= 2^11

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(counts_.size()); }
  /// The shares of all symbols before this one, of 2^shareBits.
  [[nodiscard]] std::uint32_t start(std::uint32_t symbol) const { return starts_[symbol]; }
  /// The last symbol that starts at or before this share.
  [[nodiscard]] std::uint32_t symbolAt(std::uint32_t share) const;
  void learn(std::uint32_t symbol);

private:
  void update();

  std::vector<std::uint16_t> counts_;
  std::vector<std::uint16_t> starts_;
  std::uint32_t all_ = 0;
  std::uint32_t cycle_ = 0;
  std::uint32_t left_ = 0;
};

/// A model of the same symbols for each context, made when the context first comes.
class SymbolModels {
public:
  SymbolModels(std::size_t contexts, std::uint32_t symbols)
      : symbols_(symbols), models_(contexts) {}

  [[nodiscard]] SymbolModel& operator[](std::size_t context) {
    std::optional<SymbolModel>& model = models_[context];
    if (!model) model.emplace(symbols_);
    return *model;
  }

private:
  std::uint32_t symbols_;
  std::vector<std::optional<SymbolModel>> models_;
};

} // namespace espalier
