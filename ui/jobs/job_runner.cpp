#include "ui/jobs/job_runner.h"

#include <utility>

namespace espalier {

JobRunner::~JobRunner() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join(); // while it lives it posts to this
}

void JobRunner::cancel() {
  thread_.request_stop();
}

void JobRunner::finish() {
  running_ = false;
  const std::function<void()> afterwards = std::exchange(afterwards_, nullptr);
  emit finished();
  if (afterwards && !isCanceled()) afterwards();
}

} // namespace espalier
