#pragma once

#include "core/align/cloud_fit.h"
#include "core/align/pair_fit.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {

/// How one scan is laid on another so far: the targets that were picked in both, and the motion
/// that follows from them, or from the points.
///
/// Three pairs give a motion by themselves; fewer leave the one there is. A fit by points refines
/// it, until the pairs change again.
class ScanRegistration {
public:
  ScanRegistration() = default;
  /// @param start where the scan lies while nothing is known
  explicit ScanRegistration(Eigen::Isometry3d start) : start_(std::move(start)) {}

  /// A target is picked in the scan that stays, then in the one that is moved: which is next.
  [[nodiscard]] bool wantsFixed() const { return !pending_; }
  void addFixed(const Eigen::Vector3d& place) { pending_ = place; } // [L]
  void addMoved(const Eigen::Vector3d& place); // [L], its own frame; pre: !wantsFixed()
  void removeLast(); // the place, pair or fit by points that came last; pre: hasWork()
  void removePair(std::size_t pair); // pre: pair < pairs().size()
  void setFit(const CloudFit& fit);
  void reset() { *this = ScanRegistration(start_); }

  [[nodiscard]] const std::vector<TargetPair>& pairs() const { return pairs_; }
  [[nodiscard]] const std::optional<Eigen::Vector3d>& pending() const { return pending_; }
  [[nodiscard]] const std::optional<CloudFit>& byPoints() const { return byPoints_; }
  [[nodiscard]] bool hasWork() const { return pending_ || !pairs_.empty() || byPoints_; }
  /// Is it known where the moved scan lies?
  [[nodiscard]] bool isPlaced() const { return byPoints_ || byPairs_; }
  [[nodiscard]] Eigen::Isometry3d motion() const;
  /// How far the places of each pair are apart under the motion [L]; none while that is not known.
  [[nodiscard]] std::vector<double> residuals() const;
  [[nodiscard]] double rms() const; // of these [L]
  /// The same where pairs alone decide, without the fit by points; none while they do not.
  [[nodiscard]] std::optional<double> rmsByPairs() const;
  /// The pair that is farther apart than the others; none of under four, which show nothing.
  [[nodiscard]] std::optional<std::size_t> worst() const;
  [[nodiscard]] const std::string& refusal() const { return refusal_; } // why pairs give no motion

private:
  void fit();

  Eigen::Isometry3d start_ = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Vector3d> pending_; // picked in the scan that stays
  std::vector<TargetPair> pairs_;
  std::optional<PairFit> byPairs_;
  std::optional<CloudFit> byPoints_;
  std::size_t pairsOfFit_ = 0; // how many there were when it was made
  std::string refusal_;
};

} // namespace espalier
