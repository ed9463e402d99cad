#include "ui/jobs/job_queue.h"

#include "ui/jobs/job_slot.h"

#include <algorithm>
#include <limits>

namespace espalier {
namespace {

/// How many others may run where a job begins.
std::size_t mostOthers(JobPriority priority) {
  switch (priority) {
  case JobPriority::hand:
    return std::numeric_limits<std::size_t>::max();
  case JobPriority::asked:
    return 3;
  case JobPriority::background:
    return 1;
  }
  return 0;
}

} // namespace

void JobQueue::add(JobSlot& slot) {
  if (std::ranges::find(waiting_, &slot) == waiting_.end())
    waiting_.insert(std::ranges::upper_bound(waiting_, slot.priority(), {}, &JobSlot::priority),
                    &slot);
  beginNext();
}

void JobQueue::remove(JobSlot& slot) {
  std::erase(waiting_, &slot);
}

void JobQueue::ended() {
  --running_;
  beginNext();
}

void JobQueue::beginNext() {
  while (!waiting_.empty() && running_ <= mostOthers(waiting_.front()->priority())) {
    JobSlot& slot = *waiting_.front();
    waiting_.erase(waiting_.begin());
    ++running_;
    slot.begin();
  }
}

} // namespace espalier
