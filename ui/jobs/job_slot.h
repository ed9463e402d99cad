#pragma once

#include "core/base/progress.h"
#include "ui/document/shown_message.h"
#include "ui/jobs/job_queue.h"
#include "ui/jobs/yield_to_window.h"

#include <QObject>
#include <QString>

#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

namespace espalier {

/// The place of one kind of computation in the queue of jobs: its newest job runs on a worker
/// thread. One that is asked for takes the place of the one that waits. It is started on, and
/// reports to, the GUI thread. Destruction cancels what runs, and waits for it.
class JobSlot : public QObject {
  Q_OBJECT

public:
  /// @param queue must outlive the slot
  JobSlot(JobQueue& queue, JobPriority priority, QObject* parent = nullptr);
  ~JobSlot() override;

  /// Runs `work(progress)` on a worker thread once the queue lets it, then `done(result)` on the
  /// GUI thread. What runs is stopped for it, and its result dropped. `done` must not throw; after
  /// cancel() returns it is not called. `finished` comes after it. `work` owns its inputs:
  /// nothing it reads may change.
  template <class Work, class Done> void start(const QString& name, Work work, Done done) {
    ask(name, std::move(work), std::move(done));
    if (isRunning_ && isWaiting()) thread_.request_stop();
  }
  template <class Work, class Done> void start(Work work, Done done) {
    start(QString(), std::move(work), std::move(done));
  }
  /// The same, once what runs has come to its end and reported its result.
  template <class Work, class Done> void startNext(Work work, Done done) {
    ask(QString(), std::move(work), std::move(done));
  }

  /// Runs `act` once the job is over and `finished` was emitted, unless it is canceled: there it
  /// may ask, and start the next job. pre: called by `done`
  void afterwards(std::function<void()> act) { afterwards_ = std::move(act); }

  /// Asks what runs to stop, and drops what waits. What runs ends at its next look at the progress,
  /// with nothing done.
  void cancel();

  /// @throws Error naming what is busy, for what cannot be done meanwhile
  void requireIdle() const;

  [[nodiscard]] JobQueue& queue() const { return queue_; }
  [[nodiscard]] JobPriority priority() const { return priority_; }
  [[nodiscard]] bool isBusy() const { return isRunning_ || isWaiting() || isDropped_; }
  [[nodiscard]] bool isWaiting() const { return next_ != nullptr; } // the newest has not begun
  [[nodiscard]] bool isCanceled() const { return isCanceled_; }     // the job now or last
  [[nodiscard]] const QString& name() const { return name_; }       // of the job now or last

signals:
  void started(); // what is busy now was not
  void progressed(double fraction, const QString& stage);
  void failed(const QString& message);
  void finished(); // nothing runs and nothing waits; also after a failure, and after cancel()

private:
  friend class JobQueue;
  template <class Work, class Done> void ask(const QString& name, Work work, Done done);
  void wait(const QString& name, std::function<void()> begin);
  void begin(); // by the queue
  void end();
  void finishIfIdle();

  /// Runs `act` on the GUI thread, after what was posted before. There it is destroyed, too: a call
  /// in Qt's queue may be destroyed by the thread that posted it.
  template <class Act> void post(Act act) {
    auto kept = std::make_shared<Act>(std::move(act)); // it may hold what cannot be copied
    handOver([kept = std::move(kept)] { (*kept)(); });
  }
  void handOver(std::function<void()> act);
  void runNextPosted();
  template <class Work, class Done> void run(const std::stop_token& stop, Work& work, Done& done);

  JobQueue& queue_;
  JobPriority priority_;
  bool isRunning_ = false;
  bool isDropped_ = false; // canceled before it began; `finished` is to come
  bool isCanceled_ = false;
  QString name_;
  std::function<void()> next_; // begins the job that waits; none: nothing waits
  std::function<void()> afterwards_;
  std::mutex posting_;
  std::deque<std::function<void()>> posted_; // guarded by posting_
  std::jthread thread_;
};

template <class Work, class Done> void JobSlot::ask(const QString& name, Work work, Done done) {
  struct Job {
    Work work;
    Done done;
  };
  auto job = std::make_shared<Job>(Job{std::move(work), std::move(done)}); // functions are copied
  wait(name, [this, job = std::move(job)] {
    thread_ =
        std::jthread([this, job](const std::stop_token& stop) { run(stop, job->work, job->done); });
  });
}

template <class Work, class Done>
void JobSlot::run(const std::stop_token& stop, Work& work, Done& done) {
  yieldToWindow();
  const Progress progress(stop, [this, stop](double fraction, std::string_view stage) {
    const QString text = QString::fromUtf8(stage.data(), static_cast<qsizetype>(stage.size()));
    post([this, stop, fraction, text] {
      if (!stop.stop_requested()) emit progressed(fraction, text);
    });
  });
  auto kept = std::make_shared<Done>(std::move(done)); // until the end is posted
  try {
    post([stop, kept, result = work(progress)]() mutable {
      if (!stop.stop_requested()) (*kept)(std::move(result));
    });
  } catch (const Cancelled&) { // nothing to report: whoever canceled knows
  } catch (const std::exception& error) {
    post([this, stop, text = shownText(error)] {
      if (!stop.stop_requested()) emit failed(text);
    });
  }
  post([this, kept = std::move(kept)] { end(); });
}

} // namespace espalier
