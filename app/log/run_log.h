#pragma once

#include <QString>

#include <optional>

namespace espalier {

/// A run that crashed.
struct Crash {
  QString log;     // its file
  QString project; // what was worked on; empty: nothing
};

/// What the program does while its window is open, in a file of its own in `folder`: its version
/// and that of each library, commands, messages, warnings of Qt, and a crash. Holds no more than
/// names of files and what was shown; goes nowhere. Of the runs before, the logs of the last 20 are
/// kept. Where none can be written, the program goes on without.
class RunLog {
public:
  explicit RunLog(const QString& folder);
  ~RunLog();
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;

  /// $XDG_STATE_HOME/espalier, most often ~/.local/state/espalier.
  [[nodiscard]] static QString usualFolder();
  [[nodiscard]] int descriptor() const { return descriptor_; } // -1: none

private:
  int descriptor_ = -1;
};

/// The last run that crashed and was not yet taken; it is taken with this.
[[nodiscard]] std::optional<Crash> takeCrash(const QString& folder);

} // namespace espalier
