// Fuzz target: whatever the bytes, reading a model of TreeQSM gives a plant or an Error.
#include "core/io/qsm/qsm_mat.h"

#include "core/base/error.h"

#include <cstdint>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    (void)espalier::readQsmMat(in, "fuzz.mat");
  } catch (const espalier::Error&) { // what a broken file deserves
  }
  return 0;
}
