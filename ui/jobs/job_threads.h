#pragma once

namespace espalier {

/// What each thread of a job does first; null: nothing. To be set before the first job.
void setJobThreadStart(void (*start)());

void startJobThread(); // does so

} // namespace espalier
