#include "app/cli/terminal.h"

#include "core/base/listed.h"
#include "core/base/printable.h"

#include <cstdio>
#include <iostream>
#include <string>
#include <unistd.h>

namespace espalier {
namespace {

bool isTerminal() {
  return isatty(STDERR_FILENO) != 0;
}

void takeBarAway(bool isShown) {
  if (isShown) std::fputs("\r\033[K", stderr);
}

} // namespace

TerminalProgress::TerminalProgress()
    : isTerminal_(isTerminal()),
      progress_(interrupt_.token(),
                [this](double fraction, std::string_view stage) { report(fraction, stage); }) {}

TerminalProgress::~TerminalProgress() {
  clear();
}

void TerminalProgress::clear() const {
  takeBarAway(isTerminal_);
}

void TerminalProgress::report(double fraction, std::string_view stage) {
  if (!stage.empty() && (stages_.empty() || stages_.back().first != stage))
    stages_.emplace_back(stage, Clock::now());
  if (!isTerminal_) return;
  constexpr int width = 30;
  const int full = static_cast<int>(fraction * width);
  std::string bar(static_cast<std::size_t>(full), '#');
  bar.resize(width, '.');
  std::fprintf(stderr, "\r\033[K[%s] %3.0f %%  %s%s", bar.c_str(), 100 * fraction,
               printable(subject_).c_str(), stages_.empty() ? "" : stages_.back().first.c_str());
  std::fflush(stderr);
}

std::vector<std::pair<std::string, double>> TerminalProgress::stageSeconds() const {
  std::vector<std::pair<std::string, double>> result;
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    const auto end = i + 1 < stages_.size() ? stages_[i + 1].second : Clock::now();
    result.emplace_back(stages_[i].first,
                        std::chrono::duration<double>(end - stages_[i].second).count());
  }
  return result;
}

void printLine(const std::string& message) {
  takeBarAway(isTerminal());
  std::cerr << "espalier: " << printable(message) << '\n';
}

void printWritten(const std::string& what) {
  printLine("wrote " + what);
}

void printNotes(const std::vector<ShownMessage>& notes) {
  for (const ShownMessage& note : firstNotes(notes))
    printLine("note: " + inEnglish(note));
}

void printNotes(const std::vector<std::string>& notes) {
  std::vector<ShownMessage> messages;
  messages.reserve(notes.size());
  for (const std::string& note : notes)
    messages.push_back({note});
  printNotes(messages);
}

} // namespace espalier
