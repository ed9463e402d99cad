#pragma once

#include "core/evaluate/differences/differences.h"
#include "ui/view/node_look.h"

#include <vector>

namespace espalier {

/// The id of the legend of comparisonColors(), and of the action of the window that shows them.
inline constexpr auto comparisonColorId = "node_color_comparison";

/// Colors a skeleton by what differs; one legend for both skeletons of a comparison.
/// @param kinds by node id
/// @param with what it is compared with, as the legend names it; empty: the reference
[[nodiscard]] NodeColors comparisonColors(const std::vector<Difference>& kinds,
                                          const QString& with = {});

} // namespace espalier
