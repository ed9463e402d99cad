#pragma once

#include "core/base/progress.h"
#include "core/base/quadratic.h"
#include "core/cloud/organ.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace espalier {

/// What a plant is, as far as it decides how its scan is to be reconstructed. Shrubs are trees.
enum class PlantKind : std::uint8_t { bareTree, needleTree, leafyTree, herb, grass };

inline constexpr std::array allPlantKinds = {PlantKind::bareTree, PlantKind::needleTree,
                                             PlantKind::leafyTree, PlantKind::herb,
                                             PlantKind::grass};

/// What a scan shows of the kind of its plant: the shares of wood, petioles, blades and needles;
/// by their logarithms its height by its spread, and at a tenth, a half and three quarters of its
/// height the parts that a level slice has; how large a part of blades or needles is, by the height
/// of the plant, and how narrow; how many there are; and how densely the plant was scanned.
using KindFeatures = std::array<double, 12>;

/// @param points   3 x N, finite [L], z up; N > 0
/// @param organs   of each
/// @param spacing  of the points [L], > 0
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N).
[[nodiscard]] KindFeatures kindFeatures(const Eigen::Matrix3Xf& points,
                                        const std::vector<Organ>& organs, double spacing,
                                        const Progress& progress = {});

using KindOdds = std::array<Quadratic<std::tuple_size_v<KindFeatures>>, allPlantKinds.size()>;

/// The odds that are fitted, in the order of allPlantKinds: by espalier_fit_kinds
/// (tests/bench/fit_kinds.cpp) on simulated scans.
[[nodiscard]] const KindOdds& fittedKindOdds();

/// The likeliest kind, and how probable it is.
struct LikelyKind {
  PlantKind kind = PlantKind::bareTree;
  double probability = 0;

  bool operator==(const LikelyKind&) const = default;
};

/// Of the odds a share goes to all kinds alike, since shapes lead astray as often where they seem
/// sure; and herbs and grasses are as good as never as tall as trees.
/// @param height  of the plant in meters, > 0; none: not known
[[nodiscard]] LikelyKind likelyKind(const KindFeatures& features, const KindOdds& odds,
                                    std::optional<double> height = {});

} // namespace espalier
