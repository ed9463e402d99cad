#include "ui/jobs/latest_job.h"

namespace espalier {

LatestJob::LatestJob(QObject* parent) : QObject(parent) {
  connect(&runner_, &JobRunner::progressed, this, &LatestJob::progressed);
  connect(&runner_, &JobRunner::failed, this, &LatestJob::failed);
  connect(&runner_, &JobRunner::finished, this, &LatestJob::goOn);
}

void LatestJob::cancel() {
  next_ = nullptr;
  if (runner_.isRunning()) runner_.cancel();
}

void LatestJob::goOn() {
  if (const std::function<void()> next = std::exchange(next_, nullptr))
    next();
  else
    emit idled();
}

} // namespace espalier
