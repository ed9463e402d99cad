#pragma once

#include "core/io/points/adaptive_models.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace espalier::test {

/// Writes what RangeDecoder reads, with the same models.
class RangeEncoder {
public:
  void bit(BitModel& model, bool value);
  void symbol(SymbolModel& model, std::uint32_t value);
  void bits(std::uint32_t count, std::uint32_t value);
  [[nodiscard]] std::string finish() &&;

private:
  void narrow(std::uint32_t start, std::uint32_t length);

  std::string bytes_;
  std::uint32_t base_ = 0;
  std::uint32_t length_ = 0xffffffff;
};

/// Writes what IntegerDecoder reads.
class IntegerEncoder {
public:
  IntegerEncoder(std::uint32_t bits, std::size_t contexts);

  void next(RangeEncoder& out, std::int32_t prediction, std::int32_t value,
            std::size_t context = 0);
  [[nodiscard]] std::uint32_t differenceBits() const { return differenceBits_; }

private:
  std::uint32_t bits_;
  std::uint32_t differenceBits_ = 0;
  SymbolModels sizes_;
  BitModel zeroOrOne_;
  std::vector<std::optional<SymbolModel>> differences_;
};

} // namespace espalier::test
