#pragma once

#include <cstddef>

namespace espalier {

// What the program holds in memory, as the system counts it [bytes]; 0 where it does not say.

[[nodiscard]] std::size_t memoryNow();
[[nodiscard]] std::size_t memoryPeak(); // since it began, or since forgetMemoryPeak()
void forgetMemoryPeak();                // where the system lets it

} // namespace espalier
