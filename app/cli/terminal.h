#pragma once

#include "app/cli/interrupt.h"
#include "core/base/progress.h"
#include "core/base/shown_message.h"

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace espalier {

/// Progress on standard error: a bar on a terminal, nothing in a pipe. Ctrl+C stops the work.
/// One at a time.
class TerminalProgress {
public:
  TerminalProgress();
  ~TerminalProgress();
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;

  [[nodiscard]] const Progress& progress() const { return progress_; }

  /// Stops if Ctrl+C was pressed: for just before the first result is written.
  /// @throws Cancelled
  void check() const { progress_.check(); }

  /// What is shown before the stage: of many plants, which one. pre: no work is under way
  void setSubject(std::string subject) { subject_ = std::move(subject); }

  /// Takes the bar away: for just before something else is printed. Later progress shows it again.
  void clear() const;

  /// Seconds spent in each stage so far, in their order; nameless stages count to the one before.
  [[nodiscard]] std::vector<std::pair<std::string, double>> stageSeconds() const;

private:
  using Clock = std::chrono::steady_clock;
  void report(double fraction, std::string_view stage);

  std::vector<std::pair<std::string, Clock::time_point>> stages_; // when each began
  std::string subject_;
  bool isTerminal_;
  Interrupt interrupt_;
  Progress progress_;
};

/// Prints a message on its line of standard error, whatever the names in it hold.
void printLine(const std::string& message);

/// Reports on standard error what was written: "wrote pine.mtg: 1204 nodes".
void printWritten(const std::string& what);

/// Prints the notes a reader or writer had, each on its line of standard error: the first of them,
/// and how many more there are.
void printNotes(const std::vector<ShownMessage>& notes);
void printNotes(const std::vector<std::string>& notes);

} // namespace espalier
