// Fuzz target: whatever the bytes, reading a LAS file gives points or an Error, and of the points a
// cloud.
#include "core/io/points/las.h"

#include "tests/fuzz/cloud.h"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  espalier::test::requireReads<espalier::readLas>(
      std::string(reinterpret_cast<const char*>(data), size), "fuzz.las");
  return 0;
}
