#pragma once

#include "core/mtg/mtg.h"
#include "core/mtg/mtg_parser.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// The values of an edited vertex by the features of the file.
class FeatureMatch {
public:
  FeatureMatch(const Mtg& file, const Mtg& edited); // both must outlive it

  /// Whether both say the same of a feature of the file.
  [[nodiscard]] bool isSame(const std::vector<std::string>& file,
                            const std::vector<std::string>& edited, std::size_t feature) const;

  /// Whether both say the same of all features, and nothing of others.
  [[nodiscard]] bool isSame(const std::vector<std::string>& file,
                            const std::vector<std::string>& edited) const;

  /// As it is written.
  [[nodiscard]] std::string textOf(const std::vector<std::string>& edited,
                                   std::size_t feature) const;

private:
  const std::vector<MtgFeature>& features_;
  std::vector<std::optional<std::size_t>> inEdited_; // by feature of the file
  std::vector<std::size_t> added_;                   // features of the edited plant alone
};

/// A part of a text, in bytes, and what is to stand there.
struct MtgReplacement {
  std::size_t from = 0;
  std::size_t to = 0;
  std::string text;
};

/// A value as it is written; empty for none.
[[nodiscard]] std::string_view mtgValueAt(const std::vector<std::string>& values,
                                          std::size_t feature);

/// The values of a vertex at a date; none: its first ones.
[[nodiscard]] const std::vector<std::string>& mtgValuesAt(const Mtg& mtg, VertexId id,
                                                          std::optional<std::size_t> date);

/// What must change in a line so that it holds `edited`, in order. Its spacing and its comment
/// stay. None if a value cannot stand there.
[[nodiscard]] std::optional<std::vector<MtgReplacement>>
cellChanges(const ParsedMtg& file, const MtgLine& line, const std::vector<std::string>& edited,
            const FeatureMatch& match);

/// Appends `original` from `copied` on to `text`, with these changes, up to the last of them.
void appendChanged(const std::string& original, const std::vector<MtgReplacement>& changes,
                   std::size_t& copied, std::string& text);

} // namespace espalier
