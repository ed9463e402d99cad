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
  std::atomic<Eigen::Index> done = 0;
  using Range = oneapi::tbb::blocked_range<Eigen::Index>;
  oneapi::tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
    for (Eigen::Index i = range.begin(); i < range.end(); ++i) {
      if ((i - range.begin()) % grain == 0) progress.check();
      body(i);
    }
    const Eigen::Index soFar = done += static_cast<Eigen::Index>(range.size());
    progress.update(static_cast<double>(soFar) / static_cast<double>(count));
  });
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
