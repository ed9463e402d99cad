#include "ui/jobs/job_threads.h"

namespace espalier {
namespace {

void (*threadStart)() = nullptr;

} // namespace

void setJobThreadStart(void (*start)()) {
  threadStart = start;
}

void startJobThread() {
  if (threadStart != nullptr) threadStart();
}

} // namespace espalier
