#pragma once

#include "core/cloud/organ.h"
#include "core/cloud/point_set.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace espalier {

/// The points of a cloud whose organ was set by hand, by organ.
///
/// As a state, a point is of one organ at most. As the change from one state to another, a point is
/// with the organ that it had and with the one that it has: a change is its own inverse.
class OrganMarks {
public:
  using Sets = std::array<PointSet, allOrgans.size()>; // in the order of allOrgans

  OrganMarks() = default;
  explicit OrganMarks(Sets sets) : sets_(std::move(sets)) {}

  [[nodiscard]] const Sets& sets() const { return sets_; }
  [[nodiscard]] const PointSet& of(Organ organ) const {
    return sets_[static_cast<std::size_t>(organ)];
  }
  [[nodiscard]] bool isEmpty() const;
  [[nodiscard]] PointSet all() const; // of any organ
  /// The same, but for `points`, which are of `organ`; none: their organ is not set by hand.
  [[nodiscard]] OrganMarks with(const PointSet& points, std::optional<Organ> organ) const;

  /// What leads from one state to another, a state changed, or two changes as one.
  [[nodiscard]] OrganMarks operator^(const OrganMarks& other) const;
  bool operator==(const OrganMarks&) const = default;

private:
  Sets sets_;
};

} // namespace espalier
