#include "core/evaluate/match/edit_distance.h"

#include "core/base/shown_message.h"
#include "core/evaluate/match/assignment.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

namespace espalier {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t mostByMask = 6; // children on the smaller side that are assigned by masks

/// One of the two trees, with the cost of taking it away whole. Vertex 0 carries the roots.
struct EditSide {
  std::vector<std::size_t> firstChild; // by vertex, and one past the last; into `children`
  std::vector<std::size_t> children;
  std::vector<double> alone;  // of the vertex
  std::vector<double> tree;   // of it and all it carries
  std::vector<double> forest; // of all it carries

  EditSide(const ParentList& parents, const std::vector<double>& costs)
      : firstChild(parents.size() + 2, 0), children(parents.size()), alone(parents.size() + 1, 0),
        tree(parents.size() + 1, 0), forest(parents.size() + 1, 0) {
    const auto above = [&](std::size_t i) { return parents[i] ? *parents[i] + 1 : 0; };
    for (std::size_t i = 0; i < parents.size(); ++i)
      ++firstChild[above(i) + 1];
    for (std::size_t v = 1; v < firstChild.size(); ++v)
      firstChild[v] += firstChild[v - 1];
    std::vector<std::size_t> next = firstChild;
    for (std::size_t i = 0; i < parents.size(); ++i)
      children[next[above(i)]++] = i + 1;
    std::copy(costs.begin(), costs.end(), alone.begin() + 1);
    for (std::size_t v = size(); v-- > 0;) {
      for (const std::size_t child : of(v))
        forest[v] += tree[child];
      tree[v] = forest[v] + alone[v];
    }
  }

  [[nodiscard]] std::size_t size() const { return alone.size(); }
  [[nodiscard]] std::span<const std::size_t> of(std::size_t vertex) const {
    return {children.data() + firstChild[vertex], children.data() + firstChild[vertex + 1]};
  }
};

/// A path of one side that begins at a vertex, with what taking it away leaves to pay for.
struct Path {
  std::vector<std::size_t> vertices; // top down
  double beside = 0;                 // all the first carries, but the path and what its end carries
};

/// All paths of 2 to `longest` vertices down from one.
void addPaths(const EditSide& side, std::vector<std::size_t>& path, std::size_t longest,
              std::vector<Path>& paths) {
  if (path.size() >= longest) return;
  for (const std::size_t child : side.of(path.back())) {
    path.push_back(child);
    double beside = side.tree[path.front()] - side.forest[child];
    for (const std::size_t vertex : path)
      beside -= side.alone[vertex];
    paths.push_back({path, beside});
    addPaths(side, path, longest, paths);
    path.pop_back();
  }
}

/// How the distance of two forests, or of two trees, came about.
struct Step {
  enum class Kind { insertedAbove, removedAbove, assigned, substituted, merged, split } kind;
  std::size_t vertex = 0; // the child to go on with
  std::size_t path = 0;   // into the paths of the vertex
  double cost = infinity;

  void better(const Step& other) {
    if (other.cost < cost) *this = other;
  }
};

class Search {
public:
  Search(const ParentList& first, const ParentList& second, const EditCosts& costs)
      : costs_(costs), a_(first, costs.removal), b_(second, costs.insertion),
        trees_(a_.size() * b_.size()), forests_(a_.size() * b_.size()) {
    if (costs.merge) aPaths_ = pathsOf(a_);
    if (costs.split) bPaths_ = pathsOf(b_);
  }

  EditDistance run(const Progress& progress) {
    for (std::size_t i = a_.size(); i-- > 0;) {
      progress.update(1 - static_cast<double>(i + 1) / static_cast<double>(a_.size()));
      for (std::size_t j = b_.size(); j-- > 0;) {
        forests_[at(i, j)] = forestStep(i, j).cost;
        if (i > 0 && j > 0) trees_[at(i, j)] = treeStep(i, j).cost;
      }
    }
    EditDistance result{.distance = forests_[0],
                        .removingAll = a_.forest[0],
                        .insertingAll = b_.forest[0],
                        .matches = {}};
    goBack(result.matches);
    progress.update(1);
    return result;
  }

private:
  [[nodiscard]] std::size_t at(std::size_t i, std::size_t j) const { return i * b_.size() + j; }

  [[nodiscard]] std::vector<std::vector<Path>> pathsOf(const EditSide& side) const {
    std::vector<std::vector<Path>> paths(side.size());
    for (std::size_t v = 1; v < side.size(); ++v) {
      std::vector<std::size_t> path{v};
      addPaths(side, path, costs_.longestPath, paths[v]);
    }
    return paths;
  }

  [[nodiscard]] Step forestStep(std::size_t i, std::size_t j) const {
    Step best{Step::Kind::assigned, 0, 0, assigned(a_.of(i), b_.of(j))};
    for (const std::size_t c : b_.of(j))
      best.better(
          {Step::Kind::insertedAbove, c, 0, b_.forest[j] + (forests_[at(i, c)] - b_.forest[c])});
    for (const std::size_t c : a_.of(i))
      best.better(
          {Step::Kind::removedAbove, c, 0, a_.forest[i] + (forests_[at(c, j)] - a_.forest[c])});
    return best;
  }

  [[nodiscard]] Step treeStep(std::size_t i, std::size_t j) const {
    Step best{Step::Kind::substituted, 0, 0,
              forests_[at(i, j)] + costs_.substitution(i - 1, j - 1)};
    for (const std::size_t c : b_.of(j))
      best.better({Step::Kind::insertedAbove, c, 0, b_.tree[j] + (trees_[at(i, c)] - b_.tree[c])});
    for (const std::size_t c : a_.of(i))
      best.better({Step::Kind::removedAbove, c, 0, a_.tree[i] + (trees_[at(c, j)] - a_.tree[c])});
    if (costs_.merge)
      for (std::size_t p = 0; p < aPaths_[i].size(); ++p) {
        const Path& path = aPaths_[i][p];
        const double least = path.beside + forests_[at(path.vertices.back(), j)];
        if (least < best.cost)
          best.better({Step::Kind::merged, 0, p, least + costs_.merge(asGiven(path), j - 1)});
      }
    if (costs_.split)
      for (std::size_t p = 0; p < bPaths_[j].size(); ++p) {
        const Path& path = bPaths_[j][p];
        const double least = path.beside + forests_[at(i, path.vertices.back())];
        if (least < best.cost)
          best.better({Step::Kind::split, 0, p, least + costs_.split(i - 1, asGiven(path))});
      }
    return best;
  }

  /// The vertices of a path as the trees were given: without the one that carries the roots.
  static std::vector<std::size_t> asGiven(const Path& path) {
    std::vector<std::size_t> vertices = path.vertices;
    for (std::size_t& vertex : vertices)
      --vertex;
    return vertices;
  }

  /// Least cost of matching the children of two vertices, each left alone or with one other.
  [[nodiscard]] double assigned(std::span<const std::size_t> as,
                                std::span<const std::size_t> bs) const {
    double alone = 0;
    for (const std::size_t c : as)
      alone += a_.tree[c];
    for (const std::size_t c : bs)
      alone += b_.tree[c];
    if (as.empty() || bs.empty()) return alone;
    if (std::min(as.size(), bs.size()) > mostByMask)
      return leastCostAssignment(problemOf(as, bs)).cost;
    // What is saved by matching a set of the smaller side, by its bits; 0 is to match nothing.
    const bool isFirstLess = as.size() < bs.size();
    const std::span<const std::size_t> less = isFirstLess ? as : bs;
    const std::span<const std::size_t> more = isFirstLess ? bs : as;
    std::array<double, 1U << mostByMask> saved{};
    const std::size_t masks = std::size_t{1} << less.size();
    for (const std::size_t m : more)
      for (std::size_t mask = masks; mask-- > 1;) // from the full set: each of `more` once
        for (std::size_t s = 0; s < less.size(); ++s)
          if ((mask >> s & 1U) != 0)
            saved[mask] =
                std::max(saved[mask], saved[mask ^ (std::size_t{1} << s)] +
                                          (isFirstLess ? gain(less[s], m) : gain(m, less[s])));
    return alone - *std::max_element(saved.begin(), saved.begin() + masks);
  }

  [[nodiscard]] double gain(std::size_t i, std::size_t j) const {
    return a_.tree[i] + b_.tree[j] - trees_[at(i, j)];
  }

  [[nodiscard]] AssignmentProblem problemOf(std::span<const std::size_t> as,
                                            std::span<const std::size_t> bs) const {
    AssignmentProblem problem;
    for (const std::size_t i : as) {
      problem.rowAlone.push_back(a_.tree[i]);
      auto& candidates = problem.candidates.emplace_back();
      for (std::size_t k = 0; k < bs.size(); ++k)
        candidates.push_back({k, trees_[at(i, bs[k])]});
    }
    for (const std::size_t j : bs)
      problem.columnAlone.push_back(b_.tree[j]);
    return problem;
  }

  /// Follows the steps that led to the distance. Each is found anew: to keep them all would take
  /// as much memory again.
  void goBack(std::vector<EditMatch>& matches) const {
    struct Place {
      bool isTree;
      std::size_t i;
      std::size_t j;
    };
    std::vector<Place> left{{false, 0, 0}};
    while (!left.empty()) {
      const auto [isTree, i, j] = left.back();
      left.pop_back();
      const Step step = isTree ? treeStep(i, j) : forestStep(i, j);
      switch (step.kind) {
      case Step::Kind::insertedAbove:
        left.push_back({isTree, i, step.vertex});
        break;
      case Step::Kind::removedAbove:
        left.push_back({isTree, step.vertex, j});
        break;
      case Step::Kind::assigned: {
        const auto as = a_.of(i);
        const auto bs = b_.of(j);
        const Assignment pairs = leastCostAssignment(problemOf(as, bs));
        for (std::size_t k = 0; k < as.size(); ++k)
          if (pairs.columnOfRow[k]) left.push_back({true, as[k], bs[*pairs.columnOfRow[k]]});
        break;
      }
      case Step::Kind::substituted:
        matches.push_back({{i - 1}, {j - 1}, costs_.substitution(i - 1, j - 1)});
        left.push_back({false, i, j});
        break;
      case Step::Kind::merged: {
        const Path& path = aPaths_[i][step.path];
        matches.push_back({asGiven(path), {j - 1}, costs_.merge(asGiven(path), j - 1)});
        left.push_back({false, path.vertices.back(), j});
        break;
      }
      case Step::Kind::split: {
        const Path& path = bPaths_[j][step.path];
        matches.push_back({{i - 1}, asGiven(path), costs_.split(i - 1, asGiven(path))});
        left.push_back({false, i, path.vertices.back()});
        break;
      }
      }
    }
    std::ranges::sort(matches, {}, &EditMatch::first);
  }

  const EditCosts& costs_;
  EditSide a_;
  EditSide b_;
  std::vector<double> trees_;   // by pair: distance of the subtrees
  std::vector<double> forests_; // by pair: distance of what the two carry
  std::vector<std::vector<Path>> aPaths_;
  std::vector<std::vector<Path>> bPaths_;
};

} // namespace

EditDistance editDistance(const ParentList& first, const ParentList& second, const EditCosts& costs,
                          const Progress& progress) {
  if (!second.empty() && first.size() + 1 > mostEditPairs / (second.size() + 1))
    throw ShownError({espalier::Shown::tr("the edit distance of %1 and %2 parts takes too much "
                                          "memory: compare a coarser scale"),
                      {std::to_string(first.size()), std::to_string(second.size())}});
  return Search(first, second, costs).run(progress);
}

} // namespace espalier
