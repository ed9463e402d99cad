#pragma once

#include <cstdint>

namespace espalier {

/// What of the plant an area of the screen, or the pointer, takes.
enum class Depth : std::uint8_t {
  front,  // what is seen: nothing that is hidden behind wood
  through // all, however deep
};

} // namespace espalier
