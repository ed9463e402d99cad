#include "ui/jobs/job_slot.h"

#include "core/base/error.h"

#include <QMetaObject>

namespace espalier {

JobSlot::JobSlot(JobQueue& queue, JobPriority priority, QObject* parent)
    : QObject(parent), queue_(queue), priority_(priority) {}

JobSlot::~JobSlot() {
  queue_.remove(*this);
  thread_.request_stop();
  if (thread_.joinable()) thread_.join(); // while it lives it posts to this
  if (isRunning_) QMetaObject::invokeMethod(&queue_, &JobQueue::ended, Qt::QueuedConnection);
}

void JobSlot::requireIdle() const {
  if (isBusy())
    throw Error(tr("%1 is still running: wait for it, or cancel it").arg(name_).toStdString());
}

void JobSlot::wait(const QString& name, std::function<void()> begin) {
  const bool wasBusy = isBusy();
  name_ = name;
  isCanceled_ = false;
  next_ = std::move(begin);
  if (!isRunning_) queue_.add(*this);
  if (!wasBusy) emit started();
}

void JobSlot::begin() {
  isRunning_ = true;
  std::exchange(next_, nullptr)();
}

void JobSlot::cancel() {
  if (!isBusy()) return;
  isCanceled_ = true;
  queue_.remove(*this);
  if (std::exchange(next_, nullptr) && !isRunning_) {
    isDropped_ = true;
    post([this] {
      isDropped_ = false;
      finishIfIdle();
    });
  }
  if (isRunning_) thread_.request_stop();
}

void JobSlot::handOver(std::function<void()> act) {
  {
    const std::scoped_lock lock(posting_);
    posted_.push_back(std::move(act));
  }
  QMetaObject::invokeMethod(this, &JobSlot::runNextPosted, Qt::QueuedConnection);
}

void JobSlot::runNextPosted() {
  std::function<void()> act;
  {
    const std::scoped_lock lock(posting_);
    act = std::move(posted_.front());
    posted_.pop_front();
  }
  act(); // it may destroy this
}

void JobSlot::end() {
  isRunning_ = false;
  if (next_) queue_.add(*this);
  queue_.ended();
  finishIfIdle();
}

void JobSlot::finishIfIdle() {
  if (isBusy()) return;
  const std::function<void()> act = std::exchange(afterwards_, nullptr);
  emit finished();
  if (act && !isCanceled_) act();
}

} // namespace espalier
