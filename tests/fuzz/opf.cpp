// Fuzz target: whatever the bytes, reading OPF gives a plant or an Error.
#include "core/io/structures/opf.h"

#include "core/base/error.h"
#include "core/mtg/mtg_skeleton.h"

#include <cstdint>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    (void)espalier::skeletonOf(espalier::readOpf(in, "fuzz.opf").value, "fuzz.opf");
  } catch (const espalier::Error&) { // what a broken file deserves
  }
  return 0;
}
