#include "core/io/points/adaptive_models.h"

#include <algorithm>

namespace espalier {
namespace {

/// Models learn quickly at first: each cycle is a quarter longer than the one before.
std::uint32_t nextCycle(std::uint32_t cycle, std::uint32_t longest) {
  return std::min(cycle * 5 / 4, longest);
}

} // namespace

void BitModel::learn(bool bit) {
  if (!bit) ++zeros_;
  if (--left_ > 0) return;
  all_ += cycle_;
  if (all_ > 1U << shareBits) {
    all_ = (all_ + 1) / 2;
    zeros_ = (zeros_ + 1) / 2;
    if (zeros_ == all_) ++all_;
  }
  zeroShare_ = (0x80000000U / all_) * zeros_ >> (31 - shareBits);
  cycle_ = nextCycle(cycle_, 64);
  left_ = cycle_;
}

SymbolModel::SymbolModel(std::uint32_t symbols) : counts_(symbols, 1), starts_(symbols) {
  cycle_ = symbols;
  update();
  cycle_ = (symbols + 6) / 2;
  left_ = cycle_;
}

std::uint32_t SymbolModel::symbolAt(std::uint32_t share) const {
  // By halves, without branches that a processor would have to guess.
  const std::uint16_t* first = starts_.data();
  for (std::size_t size = starts_.size(); size > 1;) {
    const std::size_t half = size / 2;
    first += first[half] <= share ? half : 0;
    size -= half;
  }
  return static_cast<std::uint32_t>(first - starts_.data());
}

void SymbolModel::learn(std::uint32_t symbol) {
  ++counts_[symbol];
  if (--left_ == 0) update();
}

void SymbolModel::update() {
  all_ += cycle_;
  if (all_ > 1U << shareBits) {
    all_ = 0;
    for (std::uint16_t& count : counts_) {
      count = static_cast<std::uint16_t>((count + 1) / 2);
      all_ += count;
    }
  }
  const std::uint32_t scale = 0x80000000U / all_;
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    starts_[i] = static_cast<std::uint16_t>(scale * sum >> (31 - shareBits));
    sum += counts_[i];
  }
  cycle_ = nextCycle(cycle_, (size() + 6) * 8);
  left_ = cycle_;
}

} // namespace espalier
