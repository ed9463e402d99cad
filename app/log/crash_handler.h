#pragma once

#include <string>

namespace espalier {

/// From here on, a crash is reported before it ends the program as it would: which signal, what was
/// thrown, and where the work is that was saved until then. With a log, also where in the program.
/// Of several threads that crash at once, the first is reported.
/// Not in builds with sanitizers, which report crashes themselves.
/// @param log  descriptor of a file; -1: standard error alone
void reportCrashes(int log);

/// So that even a stack that overflows is reported of the calling thread, and of those that help
/// it: each thread that is started by hand calls it as it begins; reportCrashes() does, too.
void reportCrashesOfThread();

/// Where the work is now, to be reported by a crash; empty: nowhere.
void setWorkedOn(const std::string& path);

/// What stands before the path of the work in a log; a line that only a crash writes.
inline constexpr const char* crashLine = "crashed; worked on: ";

} // namespace espalier
