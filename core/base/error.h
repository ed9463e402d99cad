#pragma once

#include <stdexcept>

namespace espalier {

/// Something the user can act on. The message is one line: which file, where in it, what is wrong,
/// what to try.
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace espalier
