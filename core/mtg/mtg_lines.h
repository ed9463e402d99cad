#pragma once

#include "core/mtg/mtg.h"
#include "core/mtg/mtg_rows.h"

#include <string>
#include <vector>

namespace espalier {

/// Where the columns of the section MTG are.
struct MtgLayout {
  std::vector<std::size_t> columns; // by feature
  std::size_t width = 0;            // columns in all
};

/// Its class and index: "N12".
[[nodiscard]] std::string mtgLabel(const MtgVertex& vertex);

/// The lines of a vertex, one for each date, with \n. pre: mtg is as `mtgAsWritten` gives, its
/// features all have a column
[[nodiscard]] std::string mtgLines(const MtgRow& row, const Mtg& mtg, const MtgLayout& layout);

/// A value as it is written: without an exponent if it is a number that OpenAlea would take apart.
[[nodiscard]] std::string mtgCellText(const std::string& value, const MtgFeature& feature);

/// Whether a reader gets `text` back from between two tabs.
[[nodiscard]] bool survivesMtg(const std::string& text);

} // namespace espalier
