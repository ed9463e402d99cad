#include "app/cli/interrupt.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <functional>
#include <system_error>
#include <unistd.h>

namespace espalier {
namespace {

// A signal handler may do little more than write to a pipe; a thread reads it.
std::array<int, 2> wires = {-1, -1};

constexpr char stop = 's';
constexpr char end = 'e';

void send(char message) {
  const int before = errno;
  [[maybe_unused]] const ssize_t sent = ::write(wires[1], &message, 1);
  errno = before;
}

constexpr std::array<int, 2> handledSignals = {SIGINT, SIGTERM};

/// Sets who handles the signals, but for those that are ignored, as by nohup or a script's `&`.
void handleBy(void (*handler)(int)) {
  for (const int signal : handledSignals) {
    struct sigaction old {};
    ::sigaction(signal, nullptr, &old);
    if (old.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART; // reading and writing go on
    ::sigaction(signal, &action, nullptr);
  }
}

/// Hands on what the handler says, until the end.
void watch(const std::function<void()>& requestStop) {
  for (char message = 0; message != end;) {
    const ssize_t got = ::read(wires[0], &message, 1);
    if (got < 0 && errno != EINTR) return;
    if (got == 1 && message == stop) requestStop();
  }
}

} // namespace

Interrupt::Interrupt() {
  if (::pipe(wires.data()) != 0) throw std::system_error(errno, std::generic_category());
  watcher_ = std::thread([this] { watch([this] { source_.request_stop(); }); });
  handleBy([](int) { send(stop); });
}

Interrupt::~Interrupt() {
  handleBy(SIG_DFL);
  send(end);
  watcher_.join();
  for (int& wire : wires) {
    ::close(wire);
    wire = -1;
  }
}

} // namespace espalier
