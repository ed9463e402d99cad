#include "ui/jobs/yield_to_window.h"

#include "ui/jobs/job_threads.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace espalier {

void yieldToWindow() {
  startJobThread();
#ifdef __linux__
  // Here a nice value belongs to a thread, and is inherited; 10 leaves it a tenth of a processor
  // that the window wants, too. If it is refused, all run alike.
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), 10);
#endif
}

} // namespace espalier
