// Fuzz target: whatever the bytes, reading a PTX file gives points or an Error, and of the points a
// cloud.
#include "core/io/points/ptx.h"

#include "tests/fuzz/cloud.h"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  espalier::test::requireReads<espalier::readPtx>(
      std::string(reinterpret_cast<const char*>(data), size), "fuzz.ptx");
  return 0;
}
