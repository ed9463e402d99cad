#include "core/base/parallel.h"

#ifdef __SANITIZE_THREAD__

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace espalier {

void inPieces(Eigen::Index count, Eigen::Index grain,
              const std::function<void(Eigen::Index, Eigen::Index)>& work) {
  std::atomic<Eigen::Index> next = 0;
  std::mutex mutex;
  std::exception_ptr problem; // the first
  const auto run = [&] {
    try {
      for (Eigen::Index begin = 0; (begin = next.fetch_add(grain)) < count;)
        work(begin, std::min(begin + grain, count));
    } catch (...) { // is thrown on by the thread that called
      const std::lock_guard lock(mutex);
      if (!problem) problem = std::current_exception();
      next = count;
    }
  };
  const std::size_t most = oneapi::tbb::global_control::active_value(
      oneapi::tbb::global_control::max_allowed_parallelism);
  const auto pieces = static_cast<std::size_t>((count + grain - 1) / grain);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < std::min(most, pieces); ++i)
      threads.emplace_back(run);
  }
  if (problem) std::rethrow_exception(problem);
}

} // namespace espalier

#endif
