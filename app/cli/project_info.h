#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace espalier {

/// What a project holds: plant, unit, those of its skeleton (see statistics), edits.{done,undone,
/// by_hand,last,authors}, scan.{file,found,is_kept}, points_set_aside, organs_by_hand,
/// review.{reviewed,doubtful, to_do}, nodes_to_do, signed_by, has_mtg, has_reference. It is read
/// only, and may be open in a window. Notes are printed.
/// @throws Error why it cannot be read
[[nodiscard]] nlohmann::ordered_json infoOnProject(const std::string& file);

} // namespace espalier
