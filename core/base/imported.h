#pragma once

#include "core/base/shown_message.h"

#include <vector>

namespace espalier {

/// What a file held, and what its user should know of how it was read.
template <class T> struct Imported {
  T value;
  std::vector<ShownMessage> notes; // "scan.xyz: 3 of 100 points are not finite ..."
};

} // namespace espalier
