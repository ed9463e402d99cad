#pragma once

#include "core/io/points/laz_layout.h"

#include <memory>
#include <string_view>

namespace espalier {

/// Decodes the points of a chunk one after the other.
class LazDecoder {
public:
  LazDecoder() = default;
  LazDecoder(const LazDecoder&) = delete;
  LazDecoder& operator=(const LazDecoder&) = delete;
  virtual ~LazDecoder() = default;

  /// Makes the next point of the one before, of which `point` holds the bytes.
  /// @throws DamagedStream if there is none
  virtual void next(char* point) = 0;
};

/// A decoder of points whose items all lie in one stream.
/// @param bytes  of the chunk after its first point, and @param first  that point
[[nodiscard]] std::unique_ptr<LazDecoder>
pointwiseDecoder(std::string_view bytes, const std::vector<LazItem>& items, const char* first);

/// A decoder of points whose fields lie in a stream (layer) each. It decodes positions, returns,
/// flags, intensities and colors, and passes over the rest, which stays as in the first point.
/// @param bytes, first  as above
[[nodiscard]] std::unique_ptr<LazDecoder>
layeredDecoder(std::string_view bytes, const std::vector<LazItem>& items, const char* first);

} // namespace espalier
