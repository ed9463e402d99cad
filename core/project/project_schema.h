#pragma once

#include "core/project/database.h"

#include <string>

namespace espalier {

inline constexpr int applicationId = 0x4573706C; // "Espl", at byte 68 of the file

/// The version that this program writes.
[[nodiscard]] int currentSchema();

/// From this version on, a project that is only read is read as it is: later ones have more tables,
/// and nothing that older tables have is meant otherwise.
inline constexpr int firstReadAsItIs = 6;

/// Brings the tables of a database, empty or of any older version, to the current one: all or
/// nothing of the tables; rows that are damaged are left out.
/// @throws Error why it cannot be written
void upgradeSchema(const Database& database);

/// Refuses what is no project that this program can read.
/// @return  the version of its schema, at most the current one
/// @throws DamagedFile if it is no project, or has tables that a project does not have
/// @throws Error       if a newer program wrote it
[[nodiscard]] int checkedSchema(const Database& database, const std::string& file);

} // namespace espalier
