#pragma once

#include "core/base/progress.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// Rooted trees without an order among siblings: the parent of each vertex, parents before
/// children.
using ParentList = std::vector<std::optional<std::size_t>>;

/// What the edits of an edit distance cost. All costs are finite and not negative.
struct EditCosts {
  std::vector<double> removal;                                  // by vertex of the first
  std::vector<double> insertion;                                // by vertex of the second
  std::function<double(std::size_t, std::size_t)> substitution; // first by second; thread-safe
  /// A path of the first, top down, by one vertex of the second; null: nothing is merged.
  std::function<double(std::span<const std::size_t>, std::size_t)> merge;
  /// A vertex of the first by a path of the second; null: nothing is split.
  std::function<double(std::size_t, std::span<const std::size_t>)> split;
  std::size_t longestPath = 3; // vertices that are merged into one, or that one is split into
};

/// Vertices that stand for each other: one of each tree, or a path of one and one of the other.
struct EditMatch {
  std::vector<std::size_t> first;  // top down; never empty
  std::vector<std::size_t> second; // likewise; at most one of the two has several
  double cost = 0;

  bool operator==(const EditMatch&) const = default;
};

struct EditDistance {
  double distance = 0;    // least cost of all edits
  double removingAll = 0; // cost of removing the first
  double insertingAll = 0;
  std::vector<EditMatch> matches; // what is in none is removed or inserted

  /// In [0, 1]: 1 where nothing is to be edited, 0 where nothing of the first is of use.
  [[nodiscard]] double similarity() const {
    const double all = removingAll + insertingAll;
    return all > 0 ? 1 - distance / all : 1;
  }
};

/// The constrained edit distance of two unordered forests, exactly, with the matches behind it.
///
/// Vertices are matched one to one (but for paths that are merged or split), descendants to
/// descendants, and disjoint subtrees to disjoint subtrees. Without the last rule the problem is
/// NP-hard. Of matches at the same cost the first found stays: deterministic.
///
/// pre: the sizes of the lists of costs are those of the trees
/// @throws Error     if there are over `mostEditPairs` pairs of vertices
/// @throws Cancelled if `progress` asks to stop
/// Time O(A B d log d) for degrees d, longer by the number of paths where they are merged; memory
/// 16 bytes a pair.
/// Source: K. Zhang, "A constrained edit distance between unordered labeled trees", Algorithmica
/// 15, 1996; merging and splitting after P. Ferraro, C. Godin, Algorithmica 36, 2003, whose paths
/// they extend.
[[nodiscard]] EditDistance editDistance(const ParentList& first, const ParentList& second,
                                        const EditCosts& costs, const Progress& progress = {});

inline constexpr std::size_t mostEditPairs = std::size_t{1} << 28; // which take 4 GiB

} // namespace espalier
