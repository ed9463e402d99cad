// Fuzz target: whatever the bytes, reading RSML gives a skeleton or an Error.
#include "core/io/structures/rsml.h"

#include "core/base/error.h"

#include <cstdint>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    (void)espalier::readRsml(in, "fuzz.rsml");
  } catch (const espalier::Error&) { // what a broken file deserves
  }
  return 0;
}
