#pragma once

#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_writer.h"

#include <sstream>
#include <string>

namespace espalier::test {

/// A file of four scales (P, A, E and the scene) with these lines in its section MTG, which has
/// three topological columns before XX YY ZZ radius. The first of `rows` is line 21.
[[nodiscard]] inline std::string mtgText(const std::string& rows) {
  return "CODE :\tFORM-A\n\nCLASSES :\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
         "$\t0\tFREE\tFREE\tIMPLICIT\nP \t1 \tFREE\tFREE\tEXPLICIT\nA\t2\tFREE\tFREE\tEXPLICIT\n"
         "E\t3\tFREE\tFREE\tEXPLICIT\n\nDESCRIPTION :\nLEFT\tRIGHT\tRELTYPE\tMAX\nE\tE,A\t+\t?\n\n"
         "FEATURES :\nNAME\tTYPE\nXX\tREAL\nYY\tREAL\nZZ\tREAL\nMTG :\n"
         "ENTITY-CODE\t\t\tXX\tYY\tZZ\tradius\n" +
         rows;
}

[[nodiscard]] inline Imported<Mtg> readMtgRows(const std::string& rows) {
  std::istringstream in(mtgText(rows));
  return readMtg(in, "plant.mtg");
}

[[nodiscard]] inline std::string written(const Mtg& mtg) {
  std::ostringstream out;
  writeMtg(out, mtg);
  return out.str();
}

} // namespace espalier::test
