// Fuzz target: whatever the bytes, reading an MTG gives a plant or an Error.
#include "core/base/error.h"
#include "core/mtg/mtg_reader.h"

#include <cstdint>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    (void)espalier::readMtg(in, "fuzz.mtg");
  } catch (const espalier::Error&) { // what a broken file deserves
  }
  return 0;
}
