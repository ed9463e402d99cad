#pragma once

#include "core/base/imported.h"
#include "core/mtg/mtg.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// What a code such as "<U2" without ^ is attached to where others stand above it in its column
/// (but the first).
enum class MtgDialect {
  automatic,    // the mark `# dialect: previous column` if there is one; else the previous column,
                // unless a vertex then has two successors, or one of these none to follow
  continuation, // the vertex above it, as OpenAlea and PlantScan3D read
  previousColumn, // the last vertex of the column before, as the specification and Julia read
};

struct MtgReadOptions {
  MtgDialect dialect = MtgDialect::automatic;
  bool isStrict = false; // an Error for what would be repaired
};

/// Whether a file that begins so is an MTG text.
[[nodiscard]] bool isMtg(std::string_view beginning);

/// Reads the text form of an MTG: sections CODE, CLASSES, DESCRIPTION, FEATURES and MTG, where a
/// line holds a code in one of the topological columns and values in those of the features.
///
/// Values are kept as written; those of type REAL and INT must be numbers, empty, NA, None or
/// missing. Features come in the order of their columns, which need not be contiguous, then those
/// without one. See `MtgTopology` for the codes, `mtgSource` for comments and encodings.
/// Repaired, with a note: classes and types that are not declared, features listed twice, edges to
/// nothing, ranges that do not count up, values in columns without a name. The notes also say
/// which dialect was taken, if the file asks for one. The code FORM-B is refused: its source names
/// it as older and more limited, and does not say what it is.
///
/// @param file  its name, for messages
/// @throws Error naming line and column of what is wrong
/// Time O(size of the file), but for ranges: these may stand for 200000 vertices in all.
/// Source of the format: OpenAlea, "MTG file syntax", from C. Godin et al., "AMAPmod introduction
/// and reference manual", 1999.
[[nodiscard]] Imported<Mtg> readMtg(std::istream& in, const std::string& file,
                                    const MtgReadOptions& options);
[[nodiscard]] Imported<Mtg> readMtg(std::istream& in, const std::string& file);

} // namespace espalier
