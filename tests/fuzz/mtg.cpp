// Fuzz target: whatever the bytes, reading an MTG gives a plant or an Error, and a plant that can
// be written is read again as it was.
#include "core/base/error.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_writer.h"

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    const espalier::Mtg mtg = espalier::readMtg(in, "fuzz.mtg").value;
    std::ostringstream out;
    espalier::writeMtg(out, mtg);
    std::istringstream text(out.str());
    if (espalier::readMtg(text, "fuzz.mtg").value == espalier::mtgAsWritten(mtg)) return 0;
    std::cerr << "not the plant that was written:\n" << out.str();
    std::abort();
  } catch (const espalier::Error& error) { // what a broken file deserves
    if (std::getenv("FUZZ_VERBOSE") != nullptr) std::cerr << error.what() << '\n';
  }
  return 0;
}
