#include "python/job.h"

#include "core/base/error.h"
#include "core/base/parallel.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace espalier::python {
namespace {

/// What the thread of the work says to the one that waits.
struct Said {
  double fraction = 0;
  std::string stage;
  bool isNew = false;
  bool isDone = false;
};

class Job {
public:
  explicit Job(int threads, const std::function<void(const Progress&)>& work)
      : worker_([this, threads, &work] { run(threads, work); }) {}

  void requestStop() { stop_.request_stop(); }

  /// What was said since the last call. Waits for it, but not long: signals want to be seen.
  [[nodiscard]] Said next() {
    constexpr std::chrono::milliseconds often(10);
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, often, [this] { return said_.isNew || said_.isDone; });
    Said said = said_;
    said_.isNew = false;
    return said;
  }

  /// Waits for the end. @throws what the work threw
  void finish() {
    worker_.join();
    if (problem_) std::rethrow_exception(problem_);
  }

private:
  void run(int threads, const std::function<void(const Progress&)>& work) {
    const Progress progress(stop_.get_token(), [this](double fraction, std::string_view stage) {
      const std::lock_guard lock(mutex_);
      said_ = {.fraction = fraction, .stage = std::string(stage), .isNew = true};
      changed_.notify_one();
    });
    try {
      std::optional<ThreadLimit> limit;
      if (threads > 0) limit.emplace(threads);
      work(progress);
    } catch (...) {
      problem_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    said_.isDone = true;
    changed_.notify_one();
  }

  std::stop_source stop_;
  std::mutex mutex_; // of what is said
  std::condition_variable changed_;
  Said said_;
  std::exception_ptr problem_; // read after the end
  std::thread worker_;         // last: it begins at once
};

void waitFor(Job& job, const py::object& report) {
  for (Said said; !said.isDone;) {
    {
      const py::gil_scoped_release released;
      said = job.next();
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (said.isNew && !report.is_none()) report(said.fraction, said.stage);
  }
}

} // namespace

void runJob(const py::object& report, int threads,
            const std::function<void(const Progress&)>& work) {
  if (threads < 0)
    throw Error("threads is " + std::to_string(threads) + ": choose 1 or more, or 0 for all");
  Job job(threads, work);
  std::exception_ptr raised; // by Python, while the work ran
  try {
    waitFor(job, report);
  } catch (...) {
    raised = std::current_exception();
    job.requestStop();
  }
  try {
    const py::gil_scoped_release released;
    job.finish();
  } catch (...) {
    if (!raised) throw;
  }
  if (raised) std::rethrow_exception(raised);
}

} // namespace espalier::python
