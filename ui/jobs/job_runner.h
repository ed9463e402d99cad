#pragma once

#include "core/base/progress.h"
#include "ui/jobs/yield_to_window.h"

#include <QMetaObject>
#include <QObject>
#include <QString>

#include <exception>
#include <functional>
#include <memory>
#include <string_view>
#include <thread>
#include <utility>

namespace espalier {

/// Runs one long computation at a time on a worker thread. It starts on, and reports to, the GUI
/// thread. Destruction cancels the job and waits for it.
class JobRunner : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;
  ~JobRunner() override;

  /// Runs `work(progress)` on a worker thread, then `done(result)` on the GUI thread.
  /// `done` must not throw; after cancel() returns it is not called. `finished` always comes last.
  /// `work` owns its inputs: nothing it reads may change. pre: !isRunning()
  template <class Work, class Done> void start(const QString& name, Work work, Done done);

  /// Runs `act` once the job is over and `finished` has been told, unless it is canceled: there it
  /// may ask, and start the next job. pre: called by `done`
  void afterwards(std::function<void()> act) { afterwards_ = std::move(act); }

  [[nodiscard]] bool isRunning() const { return running_; }
  [[nodiscard]] bool isCanceled() const { return thread_.get_stop_token().stop_requested(); }
  [[nodiscard]] const QString& name() const { return name_; } // of the job now or last

  /// Asks the job to stop; it ends at its next look at the progress, with nothing done.
  void cancel();

signals:
  void started();
  void progressed(double fraction, const QString& stage);
  void failed(const QString& message);
  void finished(); // also after a failure, and after cancel()

private:
  /// Runs `act` on the GUI thread, after what was posted before.
  template <class Act> void post(Act act) {
    QMetaObject::invokeMethod(this, std::move(act), Qt::QueuedConnection);
  }
  void finish();

  bool running_ = false;
  QString name_;
  std::function<void()> afterwards_;
  std::jthread thread_;
};

template <class Work, class Done> void JobRunner::start(const QString& name, Work work, Done done) {
  Q_ASSERT(!running_);
  running_ = true;
  name_ = name;
  thread_ = std::jthread([this, work = std::move(work),
                          done = std::move(done)](const std::stop_token& stop) mutable {
    yieldToWindow();
    const Progress progress(stop, [this, stop](double fraction, std::string_view stage) {
      const QString text = QString::fromUtf8(stage.data(), static_cast<qsizetype>(stage.size()));
      post([this, stop, fraction, text] {
        if (!stop.stop_requested()) emit progressed(fraction, text);
      });
    });
    try {
      using Result = decltype(work(progress));
      auto result = std::make_shared<Result>(work(progress)); // shared: events are copied
      post([stop, done = std::move(done), result = std::move(result)]() mutable {
        if (!stop.stop_requested()) done(std::move(*result));
      });
    } catch (const Cancelled&) { // nothing to tell: who cancelled knows
    } catch (const std::exception& error) {
      post([this, stop, text = QString::fromUtf8(error.what())] {
        if (!stop.stop_requested()) emit failed(text);
      });
    }
    post([this] { finish(); });
  });
  emit started();
}

} // namespace espalier
