#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// The value below which a share of all lie, one of them; none of no values. pre: share in [0, 1)
[[nodiscard]] inline std::optional<double> quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nullopt;
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

} // namespace espalier
