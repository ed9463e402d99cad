#pragma once

#include "ui/jobs/job_runner.h"

#include <QObject>

#include <functional>
#include <utility>

namespace espalier {

/// Runs the newest of many computations on a worker thread: one that is asked for takes the place
/// of the one that waits, and is never queued behind it. Destruction cancels what runs, and waits.
class LatestJob : public QObject {
  Q_OBJECT

public:
  explicit LatestJob(QObject* parent = nullptr);

  /// As JobRunner::start(); what runs is stopped for it, and its result dropped.
  template <class Work, class Done> void start(Work work, Done done) {
    startNext(std::move(work), std::move(done));
    if (next_ != nullptr) runner_.cancel();
  }
  /// The same, once what runs has come to its end and told its result.
  template <class Work, class Done> void startNext(Work work, Done done) {
    next_ = [this, work = std::move(work), done = std::move(done)]() mutable {
      runner_.start(QString(), std::move(work), std::move(done));
    };
    if (!runner_.isRunning()) goOn();
  }
  void cancel();                                                    // what runs, and what waits
  [[nodiscard]] bool isWaiting() const { return next_ != nullptr; } // something newer
  [[nodiscard]] bool isBusy() const { return runner_.isRunning() || next_ != nullptr; }

signals:
  void progressed(double fraction, const QString& stage); // of what is wanted still
  void failed(const QString& message);
  void idled(); // nothing runs and nothing waits

private:
  void goOn();

  std::function<void()> next_; // none: nothing waits
  JobRunner runner_;
};

} // namespace espalier
