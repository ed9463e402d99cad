// Fuzz target: whatever the bytes, reading a table of cylinders gives a plant or an Error.
#include "core/io/qsm/qsm_table.h"

#include "core/base/error.h"

#include <cstdint>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    (void)espalier::readQsmTable(in, "fuzz.csv");
  } catch (const espalier::Error&) { // what a broken file deserves
  }
  return 0;
}
