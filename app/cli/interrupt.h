#pragma once

#include <stop_token>
#include <thread>

namespace espalier {

/// While it lives, Ctrl+C and a request to end (SIGINT, SIGTERM) ask for a stop instead of ending
/// the program. Signals that the caller of the program has turned off stay so. One at a time.
class Interrupt {
public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

private:
  std::stop_source source_;
  std::thread watcher_;
};

} // namespace espalier
