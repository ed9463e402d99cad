#pragma once

#include <QObject>

#include <cstddef>
#include <vector>

namespace espalier {

class JobSlot;

/// How soon a job begins while others run.
enum class JobPriority {
  hand,      // follows the mouse and the keys: at once
  asked,     // the user asked for it and can wait
  background // nobody asked
};

/// The jobs of a window, each of which has a place here (JobSlot). A job of the hand begins at
/// once, one that was asked for beside at most three others, one in the background beside at most
/// one; the others wait: those of the hand first, those of the background last, and of one priority
/// in the order in which they were asked for. All jobs run below the priority of the window itself
/// (yield_to_window.h).
class JobQueue : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  [[nodiscard]] std::size_t runningCount() const { return running_; }
  [[nodiscard]] std::size_t waitingCount() const { return waiting_.size(); }

private:
  friend class JobSlot;
  void add(JobSlot& slot);    // to wait, and begin when it may
  void remove(JobSlot& slot); // if it waits
  void ended();               // one that ran
  void beginNext();

  std::vector<JobSlot*> waiting_; // in the order in which they begin
  std::size_t running_ = 0;
};

} // namespace espalier
