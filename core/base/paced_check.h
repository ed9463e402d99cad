#pragma once

#include "core/base/progress.h"

#include <cstddef>

namespace espalier {

/// Looks at a progress now and then, from within a loop whose steps are short. One per thread.
class PacedCheck {
public:
  explicit PacedCheck(const Progress& progress) : progress_(progress) {}

  /// Notes that `steps` of some ns each were done.
  /// @throws Cancelled if a stop was asked for, and about a million steps were done since it was
  /// looked at last
  void after(std::size_t steps) {
    done_ += steps;
    if (done_ < pace) return;
    done_ = 0;
    progress_.check();
  }

private:
  static constexpr std::size_t pace = 1 << 20;

  const Progress& progress_;
  std::size_t done_ = pace; // looks at once
};

} // namespace espalier
