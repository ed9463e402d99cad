#include "ui/jobs/memory_use.h"

#include <fstream>
#include <string>

namespace espalier {
namespace {

/// A line of /proc/self/status, such as "VmHWM:    12345 kB".
std::size_t statusOf(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stoull(line.substr(name.size() + 1));
  return 0;
}

} // namespace

std::size_t memoryNow() {
  return statusOf("VmRSS");
}

std::size_t memoryPeak() {
  return statusOf("VmHWM");
}

void forgetMemoryPeak() {
  std::ofstream("/proc/self/clear_refs") << 5; // proc(5)
}

} // namespace espalier
