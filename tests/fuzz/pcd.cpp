// Fuzz target: whatever the bytes, reading a PCD file gives points or an Error, and of the points a
// cloud.
#include "core/io/points/pcd.h"

#include "tests/fuzz/cloud.h"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  espalier::test::requireReads<espalier::readPcd>(
      std::string(reinterpret_cast<const char*>(data), size), "fuzz.pcd");
  return 0;
}
