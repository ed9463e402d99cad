#pragma once

#include "core/reconstruct/attractors.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// A length that follows the density of the points: `least` at density 0, `greatest` at 1 [L].
struct AdaptiveLength {
  double least = 0;
  double greatest = 0;

  [[nodiscard]] double at(double density) const { return least + density * (greatest - least); }
};

/// A skeleton that grows step by step towards attractors.
class GrowingTree {
public:
  struct Shoot {
    std::uint32_t parent;
    Eigen::Vector3d place; // [L]
  };

  /// @param kill, reach in steps: see Attractors::meet
  GrowingTree(Attractors& attractors, const AdaptiveLength& step, double kill, double reach)
      : attractors_(attractors), step_(step), kill_(kill), reach_(reach) {}

  /// Adds the root. @return its number, 0
  std::uint32_t addRoot(const Eigen::Vector3d& place);

  /// Adds a node per shoot, which the attractors meet one after the other. On all threads.
  /// @return their numbers, one after the other
  /// @throws Cancelled if `progress` asks to stop
  std::vector<std::uint32_t> add(const std::vector<Shoot>& shoots, const Progress& progress);

  /// Where a child of `node` would stand that is one step off in the mean direction of `pulling`;
  /// none if they pull nowhere, or it would not come nearer to one of them by a tenth of a step:
  /// without this rule a node between its points would grow for ever.
  [[nodiscard]] std::optional<Shoot> shootTowards(std::uint32_t node,
                                                  const std::vector<std::uint32_t>& pulling) const;

  /// Where growth goes on when it has ended: at points that no node is in reach of, attached to the
  /// nodes nearest to them. Nearest first; once for all points that lie together, each in reach of
  /// another, and not for those that stand alone. What lies much farther off than the nearest waits
  /// until that has grown.
  /// @param widestGap [L] wider ones are not bridged; 0 = all are
  /// @throws Cancelled if `progress` asks to stop
  [[nodiscard]] std::vector<Shoot> shootsAcrossGaps(double widestGap,
                                                    const Progress& progress = {});

  [[nodiscard]] const Eigen::Vector3d& place(std::uint32_t node) const { return places_[node]; }
  [[nodiscard]] double density(std::uint32_t node) const { return densities_[node]; }
  [[nodiscard]] double reach(std::uint32_t node) const { return reach_ * steps_[node]; } // [L]
  /// One node for each, in their order.
  [[nodiscard]] Skeleton skeleton() const;

private:
  /// What a new node would be.
  struct Sprout {
    double density = 0; // of the nearest point
    double step = 0;    // [L]
    std::vector<Neighbor> met;
  };
  [[nodiscard]] Sprout sproutAt(const Eigen::Vector3d& place) const;
  std::uint32_t add(const Sprout& sprout, const Eigen::Vector3d& place,
                    std::optional<std::uint32_t> parent);

  /// From a point that no node has been in reach of to the node nearest to it.
  struct Gap {
    float squaredWidth; // [L^2]
    std::uint32_t point;
    std::uint32_t node;
  };

  /// Forgets the gaps of points that were reached since, and looks for nearer nodes among those
  /// added since. Time O(G log n) for G gaps and n new nodes, far less where these are far off.
  void updateGaps(const Progress& progress);

  /// The nearest gaps of squared widths over `beyond` [L^2], with those little wider; nearest
  /// first.
  /// @param widest [L] wider ones are left out
  [[nodiscard]] std::vector<Gap> nearestGaps(float beyond, double widest) const;

  /// The first of all gaps whose points lie together, each in reach of another.
  [[nodiscard]] std::vector<Gap> onePerClump(const std::vector<Gap>& gaps,
                                             const Progress& progress) const;

  Attractors& attractors_;
  AdaptiveLength step_;
  double kill_;
  double reach_;
  std::vector<Eigen::Vector3d> places_;
  std::vector<double> steps_;
  std::vector<double> densities_; // of the nearest point
  std::vector<std::optional<NodeId>> parents_;
  std::vector<Gap> gaps_;       // by number of the point
  std::size_t nodesOfGaps_ = 0; // that gaps_ know of
  std::vector<bool> isDust_;    // by point: too few live beside it, and never will more
};

} // namespace espalier
