#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <functional>

namespace espalier {

#ifdef __SANITIZE_THREAD__
/// Runs work(begin, end) for pieces of [0, count) on threads of its own: ThreadSanitizer does not
/// see into TBB, and would take the order that it keeps for none.
void inPieces(Eigen::Index count, Eigen::Index grain,
              const std::function<void(Eigen::Index, Eigen::Index)>& work);
#else
/// Runs work(begin, end) for pieces of [0, count) of about `grain` and more, on all threads.
template <class Work> void inPieces(Eigen::Index count, Eigen::Index grain, const Work& work) {
  using Range = oneapi::tbb::blocked_range<Eigen::Index>;
  oneapi::tbb::parallel_for(Range(0, count, grain),
                            [&](const Range& range) { work(range.begin(), range.end()); });
}
#endif

/// Runs body(i) for each i in [0, count), on all threads.
///
/// Bodies must not read what other bodies write; then the result is the same for any number of
/// threads. `grain` bodies are run between two looks at `progress`.
/// @throws Cancelled if `progress` asks to stop; whatever a body throws
template <class Body>
void parallelFor(Eigen::Index count, const Body& body, const Progress& progress = {},
                 Eigen::Index grain = 256) {
  std::atomic<Eigen::Index> done = 0;
  inPieces(count, grain, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      if ((i - begin) % grain == 0) progress.check();
      body(i);
    }
    const Eigen::Index soFar = done.fetch_add(end - begin) + end - begin;
    progress.update(static_cast<double>(soFar) / static_cast<double>(count));
  });
}

/// Sorts on all threads. pre: no two elements are equal by `less`, so that the order is the same
/// for any number of threads
template <class Iterator, class Less>
void parallelSort(Iterator begin, Iterator end, const Less& less) {
#ifdef __SANITIZE_THREAD__ // see inPieces
  std::sort(begin, end, less);
#else
  oneapi::tbb::parallel_sort(begin, end, less);
#endif
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
