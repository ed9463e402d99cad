// Fuzz target: whatever the bytes, reading a LAZ file gives points or an Error, and of the points a
// cloud.
#include "core/io/points/laz.h"

#include "core/base/error.h"
#include "tests/fuzz/cloud.h"

#include <cstdint>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    espalier::test::requireCloud(espalier::readLaz(in, "fuzz.laz").value);
  } catch (const espalier::Error&) { // what a broken file deserves
  }
  return 0;
}
