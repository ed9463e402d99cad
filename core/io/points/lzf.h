#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace espalier {

/// Unpacks data packed with LZF, as in compressed PCD files; none if they do not unpack to exactly
/// `size` bytes. No more memory is taken than such data can fill.
/// Format: M. Lehmann, LibLZF (liblzf).
[[nodiscard]] std::optional<std::string> unpackedLzf(std::string_view packed, std::size_t size);

} // namespace espalier
