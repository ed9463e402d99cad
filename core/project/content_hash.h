#pragma once

#include "core/base/progress.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace espalier {

/// 64 bits that separate contents that differ by accident, not those made to deceive.
/// Source: Y. Collet, "xxHash fast digest algorithm", specification 0.1.1 (XXH64, seed 0, of
/// libxxhash).
[[nodiscard]] std::uint64_t contentHash(std::string_view bytes);

/// The same of what a file holds: as fast as the disk.
/// @throws Error     if it cannot be read
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::uint64_t contentHashOfFile(const std::filesystem::path& path,
                                              const Progress& progress = {});

} // namespace espalier
