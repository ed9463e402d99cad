#pragma once

#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// What a tip adds to a plant: the path along the plant from where it leaves something longer, or
/// from the root, up to the tip. Both ends are counted from the root [L].
struct Bar {
  double from = 0;
  double to = 0;
  bool operator==(const Bar&) const = default;
};

/// The bars of all tips: the shape of a plant whatever its place and the order of its branches.
/// Where several leave together, the one that reaches farthest goes on. Time O(N).
/// Source: L. Kanari et al., "A topological representation of branching neuronal morphologies",
/// Neuroinformatics 16, 2018, with the path length along the plant as the filtration.
[[nodiscard]] std::vector<Bar> barcode(const Skeleton& skeleton);

/// How far two barcodes differ, in [0, 1]: 0 where they are the same, 1 where no bar has anything
/// like it in the other.
///
/// Each bar is a spot of a width of a twentieth of the longest of both, by its ends in the plane;
/// the difference of both pictures as a share of both together. Differs from the source: pictures
/// are not brought to the same sum, so that bars that are too many count.
/// Symmetric; scaling both changes nothing. Time O(bars).
[[nodiscard]] double barcodeDistance(const std::vector<Bar>& a, const std::vector<Bar>& b);

} // namespace espalier
