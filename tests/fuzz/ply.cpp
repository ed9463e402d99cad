// Fuzz target: whatever the bytes, reading a PLY file gives points or an Error, and of the points a
// cloud.
#include "core/io/points/ply.h"

#include "tests/fuzz/cloud.h"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  espalier::test::requireReads<espalier::readPly>(
      std::string(reinterpret_cast<const char*>(data), size), "fuzz.ply");
  return 0;
}
