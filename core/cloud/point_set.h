#pragma once

#include "core/cloud/point_cloud.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// Some of the points of a cloud, by their columns.
///
/// Kept as runs of columns: a cloud is sorted along a curve that fills space, so what lies together
/// makes few runs, and a set costs what its border does. Any operation takes time linear in the
/// runs, unless it says otherwise. A set knows nothing of the size of its cloud.
class PointSet {
public:
  /// Columns from `begin` to before `end`.
  struct Run {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    bool operator==(const Run&) const = default;
  };

  PointSet() = default;
  /// @param points in ascending order, none twice
  [[nodiscard]] static PointSet of(const std::vector<Eigen::Index>& points);
  [[nodiscard]] static PointSet firstOf(Eigen::Index count); // the columns before `count`
  /// None if the runs are not in order, touch each other, or one is empty.
  [[nodiscard]] static std::optional<PointSet> ofRuns(std::vector<Run> runs);

  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
  [[nodiscard]] bool isEmpty() const { return runs_.empty(); }
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool contains(Eigen::Index point) const;  // O(log runs)
  [[nodiscard]] std::vector<Eigen::Index> points() const; // ascending; O(size)

  [[nodiscard]] PointSet operator|(const PointSet& other) const; // in either
  [[nodiscard]] PointSet operator&(const PointSet& other) const; // in both
  [[nodiscard]] PointSet operator-(const PointSet& other) const; // in this alone
  [[nodiscard]] PointSet operator^(const PointSet& other) const; // in one alone
  bool operator==(const PointSet&) const = default;

private:
  std::vector<Run> runs_; // in order; none is empty or touches the next
};

/// The columns before `count` that are not in `points`, ascending. O(count).
[[nodiscard]] std::vector<Eigen::Index> others(const PointSet& points, Eigen::Index count);

/// A cloud without some of its points, in the order that it has, about the same origin. O(N).
[[nodiscard]] PointCloud without(const PointCloud& cloud, const PointSet& points);

} // namespace espalier
