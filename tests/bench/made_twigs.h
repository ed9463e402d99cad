#pragma once

#include "core/base/random.h"
#include "core/reconstruct/trace.h"
#include "tests/bench/judged_twigs.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// A plant with what a tool made on it.
struct Made {
  Skeleton plant;
  std::vector<NodeId> added;
};

enum class Tool : std::uint8_t { trace, stroke, regrow, points, missing };
inline constexpr std::array toolNames = {"trace", "stroke", "regrow", "points", "missing"};

/// A plant to make twigs of.
struct Subject {
  std::string name;
  std::shared_ptr<const PointCloud> cloud;
  double spacing = 0;
  const PrunedPlant& plant;
  std::optional<TraceGraph> graph;
  double step = 0; // between nodes, as the tools have it [L]
};

/// What a tool makes of a twig, by a hand that errs; none: it does not apply.
[[nodiscard]] std::optional<Made> madeBy(Tool tool, const Subject& subject, const Twig& twig,
                                         Random& random);

} // namespace espalier
