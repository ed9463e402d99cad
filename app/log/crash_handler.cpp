#include "app/log/crash_handler.h"

#include <tbb/task_scheduler_observer.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <execinfo.h>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace espalier {
namespace {

/// A text of the handler, which may neither allocate nor lock. A crash while it is set may show
/// both the old and the new.
class FixedText {
public:
  void set(std::string_view text) {
    const std::size_t size = std::min(text.size(), bytes_.size());
    std::copy_n(text.data(), size, bytes_.data());
    size_ = size;
  }
  [[nodiscard]] std::string_view get() const { return {bytes_.data(), size_}; }

private:
  std::array<char, 4096> bytes_{};
  std::size_t size_ = 0;
};

FixedText workedOn;
FixedText thrown;
int logDescriptor = -1;

void put(int descriptor, std::string_view text) {
  while (descriptor >= 0 && !text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string_view nameOf(int signal) {
  switch (signal) {
  case SIGSEGV:
    return "memory that is not there was used (SIGSEGV)";
  case SIGBUS:
    return "a file in memory ended, or its disk is full (SIGBUS)";
  case SIGFPE:
    return "a computation that has no result (SIGFPE)";
  case SIGILL:
    return "an instruction that this processor does not have (SIGILL)";
  default:
    return "the program found a mistake of its own (SIGABRT)";
  }
}

void describe(int descriptor, int signal) {
  put(descriptor, "\nespalier: crashed: ");
  put(descriptor, thrown.get().empty() ? nameOf(signal) : thrown.get());
  put(descriptor, "\n");
  if (workedOn.get().empty()) return;
  put(descriptor, "espalier: what was done until then is in ");
  put(descriptor, workedOn.get());
  put(descriptor, ": start Espalier again to go on with it\n");
}

extern "C" void onCrash(int signal) {
  static std::atomic<pid_t> reporter = 0; // the first thread that crashed
  pid_t first = 0;
  if (reporter.compare_exchange_strong(first, ::gettid())) {
    // First what the next start looks for: where the stack is destroyed, the frames end the
    // program.
    put(logDescriptor, "\n");
    put(logDescriptor, crashLine);
    put(logDescriptor, workedOn.get());
    put(logDescriptor, "\n");
    describe(STDERR_FILENO, signal);
    describe(logDescriptor, signal);
    std::array<void*, 64> frames{};
    const int count = ::backtrace(frames.data(), static_cast<int>(frames.size()));
    if (logDescriptor >= 0) ::backtrace_symbols_fd(frames.data(), count, logDescriptor);
  } else {
    while (first != ::gettid()) // what has crashed since waits until the report ends the program
      ::pause();
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

[[noreturn]] void onTerminate() {
  try {
    if (const std::exception_ptr current = std::current_exception())
      std::rethrow_exception(current);
  } catch (const std::exception& problem) {
    thrown.set(problem.what());
  } catch (...) {
    thrown.set("something was thrown that nobody caught");
  }
  std::abort();
}

/// What the handler runs on: a stack that overflowed has no room for it.
class CrashStack {
public:
  CrashStack() {
    const stack_t place = {.ss_sp = bytes_.data(), .ss_flags = 0, .ss_size = bytes_.size()};
    ::sigaltstack(&place, nullptr);
  }
  ~CrashStack() {
    const stack_t none = {.ss_sp = nullptr, .ss_flags = SS_DISABLE, .ss_size = 0};
    ::sigaltstack(&none, nullptr);
  }
  CrashStack(const CrashStack&) = delete;
  CrashStack& operator=(const CrashStack&) = delete;

private:
  std::vector<char> bytes_ = std::vector<char>(65536);
};

void giveStack() {
  static thread_local const CrashStack stack;
}

/// Gives one to each thread that helps the one it was made by.
class HelpersStacks : public tbb::task_scheduler_observer {
public:
  HelpersStacks() { observe(true); }
  ~HelpersStacks() override { observe(false); }
  HelpersStacks(const HelpersStacks&) = delete;
  HelpersStacks& operator=(const HelpersStacks&) = delete;
  void on_scheduler_entry(bool /*isWorker*/) override { giveStack(); }
};

} // namespace

void reportCrashesOfThread() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  giveStack();
  static thread_local const HelpersStacks helpers;
#else
  static_cast<void>(giveStack);
#endif
}

void reportCrashes(int log) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  logDescriptor = log;
  reportCrashesOfThread();
  std::array<void*, 1> first{};
  ::backtrace(first.data(), 1); // loads what it needs, which the handler must not do
  struct sigaction action = {};
  action.sa_handler = onCrash;
  action.sa_flags = SA_ONSTACK;
  ::sigemptyset(&action.sa_mask);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    ::sigaction(signal, &action, nullptr);
  std::set_terminate(onTerminate);
#else
  static_cast<void>(log);
  static_cast<void>(onCrash);
  static_cast<void>(onTerminate);
#endif
}

void setWorkedOn(const std::string& path) {
  workedOn.set(path);
}

} // namespace espalier
