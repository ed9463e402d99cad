#pragma once

namespace espalier {

/// From now on the calling thread, and the threads that it starts, run only on what the window
/// leaves of the processors: a frame is not to wait for a job.
void yieldToWindow();

} // namespace espalier
