// Fuzz target: whatever the bytes, reading an E57 file gives points or an Error, and of the points
// a cloud. The checksums of its pages are mended first, as they would refuse all that is damaged.
#include "core/io/points/e57.h"

#include "tests/core/io/points/e57_writer.h"
#include "tests/fuzz/cloud.h"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  for (const std::string& file : {bytes, espalier::test::healedE57(bytes)})
    espalier::test::requireReads<espalier::readE57>(file, "fuzz.e57");
  return 0;
}
