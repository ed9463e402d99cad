#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>

namespace espalier {

/// Runs body(i) for each i in [0, count), on all threads.
///
/// Bodies must not read what other bodies write; then the result is the same for any number of
/// threads. `grain` bodies are run between two looks at `progress`.
/// @throws Cancelled if `progress` asks to stop; whatever a body throws
template <class Body>
void parallelFor(Eigen::Index count, const Body& body, const Progress& progress = {},
                 Eigen::Index grain = 256) {
  // TBB orders what is before, in and after its bodies; these two say so to ThreadSanitizer as
  // well, which does not see into TBB. They order no body with another: it still finds races of
  // bodies.
  std::atomic<bool> hasBegun = false;
  std::atomic<Eigen::Index> done = 0;
  hasBegun.store(true, std::memory_order_release);
  using Range = oneapi::tbb::blocked_range<Eigen::Index>;
  oneapi::tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
    static_cast<void>(hasBegun.load(std::memory_order_acquire));
    for (Eigen::Index i = range.begin(); i < range.end(); ++i) {
      if ((i - range.begin()) % grain == 0) progress.check();
      body(i);
    }
    const auto size = static_cast<Eigen::Index>(range.size());
    const Eigen::Index soFar = done.fetch_add(size, std::memory_order_release) + size;
    progress.update(static_cast<double>(soFar) / static_cast<double>(count));
  });
  static_cast<void>(done.load(std::memory_order_acquire));
}

/// While it lives, loops run on at most `threads` threads.
class ThreadLimit {
public:
  explicit ThreadLimit(int threads) // pre: threads >= 1
      : control_(oneapi::tbb::global_control::max_allowed_parallelism,
                 static_cast<std::size_t>(threads)) {}

private:
  oneapi::tbb::global_control control_;
};

} // namespace espalier
