#pragma once

#include "core/base/error.h"
#include "core/io/bytes/scalar.h"

#include <bit>
#include <cstdint>
#include <string>

namespace espalier::test {

/// What `read` says is wrong; empty if nothing is.
template <class Read> std::string errorOf(const Read& read) {
  try {
    (void)read();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// How a LAS sample is made.
struct LasSample {
  int minorVersion = 2;
  int format = 0;
  int points = 3;
  std::size_t extraBytes = 0;  // at the end of each record
  int withheld = -1;           // the point that is flagged
  int colorUnit = 256;         // colors are 10, 20 and 30 of these, and one more per point
  std::uint64_t promised = 0;  // points stated in the header, 0: as many as there are
  std::uint8_t formatBits = 0; // set in the byte of the format
};

/// A LAS file. Point i lies at (1000 + i, 2000 + 2 i, 3 i) mm over (500000, 4000000, 100) m and has
/// intensity 100 + i.
[[nodiscard]] std::string lasFile(const LasSample& sample);

/// A binary PLY file of three points with a property of every scalar type: x short, y int, z
/// double, red ushort (in 256ths), green and blue likewise, scalar_Intensity float; before them an
/// element of lists, after them faces. Point i lies at (-1 - i, 100000 + i, 0.25 i) with color (10
/// + i, 20, 30) and intensity i / 2.
[[nodiscard]] std::string plyFile(std::endian order);
[[nodiscard]] std::string asciiPlyFile();

enum class PcdKind : std::uint8_t { ascii, binary, compressed };

/// A PCD file of three points with fields x y z (float), normal (3 floats), rgb (float) and
/// intensity (ushort). Point i lies at (1 + i, 2.5, -i) with color (200, 100, 10 + i) and intensity
/// 7 i.
[[nodiscard]] std::string pcdFile(PcdKind kind);

/// A text of points with intensity and color, named in a first line.
[[nodiscard]] std::string xyzFile();

/// Two blocks of 2 x 2 directions, the first with colors; one direction has no return.
[[nodiscard]] std::string ptxFile();

/// The scene of bgeomFile() as text.
[[nodiscard]] std::string geomFile();

/// A structure of two plants with branches, in each format.
[[nodiscard]] std::string mtgFile();
[[nodiscard]] std::string nodeListFile();
[[nodiscard]] std::string swcFile();
[[nodiscard]] std::string treefileFile();
[[nodiscard]] std::string graphmlFile();
[[nodiscard]] std::string opfFile();
[[nodiscard]] std::string rsmlFile();

} // namespace espalier::test
