#include "ui/jobs/job_runner.h"

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
  emit finished();
}

} // namespace espalier
