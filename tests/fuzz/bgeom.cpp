// Fuzz target: whatever the bytes, reading a .bgeom gives points or an Error.
#include "core/io/plantgl/bgeom.h"

#include "core/base/error.h"

#include <cstdint>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    (void)espalier::readBgeom(in, "fuzz.bgeom");
  } catch (const espalier::Error&) { // what a broken file deserves
  }
  return 0;
}
