#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// A point found by a SpatialIndex.
struct Neighbor {
  Eigen::Index index;    // column of the indexed points
  float squaredDistance; // [L^2]
};

/// The nearest others of each point, as one table.
struct NearestOthers {
  Eigen::Index perPoint = 0;           // entries per point
  std::vector<std::uint32_t> indices;  // point i owns [i * perPoint, (i + 1) * perPoint),
  std::vector<float> squaredDistances; // nearest first [L^2]
};

/// Finds the points near a place. Balanced k-d tree.
///
/// Build O(N log N), on all threads; one query O(log N + found). Memory about 30 bytes per point.
/// Queries are const and may run on many threads.
class SpatialIndex {
public:
  /// @param points 3 x N, finite; must outlive the index
  /// @throws Cancelled if `progress` asks to stop; it reports no progress
  explicit SpatialIndex(const Eigen::Matrix3Xf& points, const Progress& progress = {});
  explicit SpatialIndex(Eigen::Matrix3Xf&& points, const Progress& progress = {}) = delete;
  ~SpatialIndex();
  SpatialIndex(SpatialIndex&&) noexcept;
  SpatialIndex& operator=(SpatialIndex&&) noexcept;

  [[nodiscard]] Eigen::Index size() const; // points, those that are passed over too

  /// The same index, which passes over exactly the given points: one entry per point, true for
  /// those that are not to be found. Time and memory O(N) bits: the tree is shared.
  [[nodiscard]] SpatialIndex passingOver(std::vector<bool> points) const;

  /// The `count` points nearest to `place`, nearest first; all of them if there are fewer.
  [[nodiscard]] std::vector<Neighbor> nearest(const Eigen::Vector3f& place, int count) const;

  /// The nearest point within `radius` [L], if any.
  [[nodiscard]] std::optional<Neighbor>
  nearestOne(const Eigen::Vector3f& place,
             float radius = std::numeric_limits<float>::infinity()) const;

  /// The points within `radius` [L] of `place`, in no order that means anything.
  [[nodiscard]] std::vector<Neighbor> within(const Eigen::Vector3f& place, float radius) const;

  /// The nearest point within `radius` [L] that `accepts`, if any.
  [[nodiscard]] std::optional<Neighbor>
  nearestIf(const Eigen::Vector3f& place, float radius,
            const std::function<bool(Eigen::Index)>& accepts) const;

  /// For each indexed point its `count` nearest others; all others if there are fewer.
  /// pre: it passes over none. Uses all threads. Time O(N count log N). @throws Cancelled if
  /// `progress` asks to stop
  [[nodiscard]] NearestOthers nearestOthers(int count, const Progress& progress = {}) const;

  /// For each indexed point the squared distance to the farthest of its `count` nearest others
  /// [L^2]; of all others if there are fewer, 0 if there is none. Otherwise as nearestOthers(),
  /// with memory for one number per point.
  [[nodiscard]] std::vector<float> squaredReaches(int count, const Progress& progress = {}) const;

private:
  template <class Accepts>
  [[nodiscard]] std::optional<Neighbor> nearestAccepted(const Eigen::Vector3f& place, float radius,
                                                        const Accepts& accepts) const;
  [[nodiscard]] Eigen::Index othersPerPoint(int count) const;
  template <class Visit>
  void forEachOther(Eigen::Index perPoint, const Visit& visit, const Progress& progress) const;

  struct Tree;
  explicit SpatialIndex(std::shared_ptr<const Tree> tree);

  std::shared_ptr<const Tree> tree_;
  std::vector<bool> isPassed_; // by point; empty: none is
};

} // namespace espalier
