// Fuzz target: whatever the bytes, reading points as text gives points or an Error, and of the
// points a cloud.
#include "core/io/points/xyz.h"

#include "tests/fuzz/cloud.h"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  espalier::test::requireReads<espalier::readXyz>(
      std::string(reinterpret_cast<const char*>(data), size), "fuzz.xyz");
  return 0;
}
