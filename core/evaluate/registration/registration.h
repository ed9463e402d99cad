#pragma once

#include "core/base/progress.h"
#include "core/graph/find_root.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>

namespace espalier {

/// A fit is poor below this share of the length near, see Registration. Grown plants of other seeds
/// reach a fourth of it with 60 segments and more, half of it with few; those that lack two fifths
/// of their twigs or half of the crown stay above it.
inline constexpr double poorFit = 0.4;

struct RegistrationOptions {
  bool turns = true;       // also turns, if it fits clearly better; false: shifts only
  UpAxis up = UpAxis::z;   // all angles about it are tried
  double searchRadius = 0; // [L], greatest shift looked for about either start; 0 = a tenth of the
                           // diagonal of the reference
  /// Share of the reach, in [0, 1]: no other angles are tried once the residual is below it.
  double goodEnough = 0;
  std::optional<Eigen::Isometry3d> motion; // known before: nothing is looked for
};

/// Where a result has to be moved to lie on its reference: turned about its middle, then shifted.
struct Registration {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity(); // from the result's frame
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();         // of the result, where it lay [L]
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();          // of that middle under motion [L]
  bool isGiven = false;                                     // the motion was known before
  double reach = 0; // [L], distances above it count as this: they are no pairs
  /// [L], mean distance between the two in both directions, each up to reach
  double residualBefore = 0;
  double residualAfter = 0; // [L], the same after the motion; if found, not above residualBefore
  double nearDistance = 0;  // [L], a fourth of the reach
  double near = 0;          // share of the length within that of the other, of both: harmonic mean

  [[nodiscard]] double angle() const;         // by which it is turned [rad], in [0, pi]
  [[nodiscard]] Eigen::Vector3d axis() const; // that it is turned about, length 1; zero: it is not
};

/// Finds the rigid motion that lays a result on its reference.
///
/// Starts from the frames as they are, from the shift that most pairs of root, branchings and tips
/// agree on, and from the same about equal centroids; refines each by pairing even samples of
/// either skeleton with the nearest place of the other (iterated closest points, distances measured
/// across the edges, far pairs fading out), and keeps the best. What one of the two lacks or has
/// too much hardly pulls. Starting elsewhere must pay: the frames as they are win near ties.
///
/// Then the same with turns: from where the shift has led, and from all angles about the axis that
/// points up (see turnedFit()). A turn is taken only if it lowers the residual by a tenth, and by a
/// hundredth of the reach; a larger turn only if it does so once more. So plants in one frame are
/// not turned to fit noise, and of the turns of a symmetric plant the least is taken.
///
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + samples) log N) for at most 8 000 samples per refinement, and about
/// 100 refinements of 300 samples for the turns.
/// Source: P. Besl, N. McKay, "A method for registration of 3-D shapes", PAMI 14(2), 1992; with the
/// weights of S. Geman, D. McClure, 1987, and distances across edges after Y. Chen, G. Medioni,
/// 1992.
[[nodiscard]] Registration registration(const Skeleton& result, const Skeleton& reference,
                                        const RegistrationOptions& options = {},
                                        const Progress& progress = {});

[[nodiscard]] Skeleton moved(Skeleton skeleton, const Eigen::Isometry3d& motion);

} // namespace espalier
