#pragma once

#include <filesystem>

namespace espalier::test {

/// Writes a project of today as version 0.1 did (schema 3): steps have no ids, the contracted
/// points name theirs by its place, and what the plant was made with by its time.
void writeAsVersion01(const std::filesystem::path& project, const std::filesystem::path& older);

/// Makes a project one of schema 5: its steps say nothing of the crown envelope. Nothing in it may
/// be of a later schema.
void writeAsSchema5(const std::filesystem::path& project);

} // namespace espalier::test
