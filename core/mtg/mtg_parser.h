#pragma once

#include "core/mtg/mtg.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_source.h"

#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// Which columns of the section MTG hold which features.
struct MtgColumns {
  std::vector<std::optional<std::size_t>> features; // by column: place in Mtg::features
  std::size_t firstFeature = 0;                     // the columns before it hold codes
};

/// A line of the section MTG that holds vertices.
struct MtgLine {
  std::size_t start = 0; // byte in the text
  std::size_t end = 0;   // behind its last byte, before its line end
  VertexId first{};      // its values belong to all vertices from first to last
  VertexId last{};
  std::optional<std::size_t> date; // place in MtgVertex::later; none: the values themselves
};

/// An MTG and where in its text its parts stand.
struct ParsedMtg {
  MtgSource source;
  Mtg mtg;
  MtgColumns columns;
  std::vector<MtgLine> lines;
  std::size_t columnsStart = 0; // first byte of the line of columns
  std::size_t start = 0;        // byte behind it
  std::vector<ShownMessage> notes;
};

/// As `readMtg`, which see.
[[nodiscard]] ParsedMtg parseMtg(std::string bytes, const std::string& file,
                                 const MtgReadOptions& options = {});

} // namespace espalier
