#include "core/graph/arborescence.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace espalier {
namespace {

/// Heaps of links by cost that are merged, and whose costs are all lowered at once: skew heaps.
class LinkHeaps {
public:
  explicit LinkHeaps(const std::vector<DirectedLink>& links) : entries_(links.size()) {
    for (std::size_t i = 0; i < links.size(); ++i)
      entries_[i].cost = links[i].cost;
  }

  static constexpr int empty = -1;

  int merge(int a, int b) {
    // Down the right sides, without recursion: these may be long.
    std::vector<int> path;
    while (a != empty && b != empty) {
      settle(a);
      settle(b);
      if (std::pair(at(b).cost, b) < std::pair(at(a).cost, a)) std::swap(a, b);
      path.push_back(a);
      a = at(a).right;
    }
    int merged = a != empty ? a : b;
    for (auto top = path.rbegin(); top != path.rend(); ++top) {
      at(*top).right = at(*top).left;
      at(*top).left = merged;
      merged = *top;
    }
    return merged;
  }

  int withoutLeast(int heap) {
    settle(heap);
    return merge(at(heap).left, at(heap).right);
  }

  void lower(int heap, double by) {
    if (heap != empty) at(heap).lowered += by;
  }

  double leastCost(int heap) {
    settle(heap);
    return at(heap).cost;
  }

private:
  struct Entry {
    double cost = 0;
    double lowered = 0; // what it and all below it are still to be lowered by
    int left = empty;
    int right = empty;
  };
  Entry& at(int entry) { return entries_[static_cast<std::size_t>(entry)]; }

  void settle(int entry) {
    Entry& own = at(entry);
    own.cost -= own.lowered;
    for (const int child : {own.left, own.right})
      if (child != empty) at(child).lowered += own.lowered;
    own.lowered = 0;
  }

  std::vector<Entry> entries_;
};

/// Which places are drawn together into one; this can be undone.
class Groups {
public:
  explicit Groups(std::uint32_t count) : parent_(count), size_(count, 1) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  [[nodiscard]] std::uint32_t find(std::uint32_t place) const {
    while (parent_[place] != place)
      place = parent_[place];
    return place;
  }
  /// @return whether the two were apart
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
    joined_.emplace_back(a, b);
    return true;
  }
  [[nodiscard]] std::size_t time() const { return joined_.size(); }
  void rewind(std::size_t time) {
    while (joined_.size() > time) {
      const auto [a, b] = joined_.back();
      joined_.pop_back();
      size_[a] -= size_[b];
      parent_[b] = b;
    }
  }

private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> size_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined_;
};

/// A cycle that was drawn together into one place.
struct Cycle {
  std::uint32_t place = 0; // that stood for it
  std::size_t time = 0;    // of the groups before it
  std::vector<int> links;  // around it
};

class Search {
public:
  Search(std::uint32_t count, std::uint32_t root, const std::vector<DirectedLink>& links)
      : links_(links), heaps_(links), groups_(count), heap_(count, LinkHeaps::empty),
        seen_(count, unseen), chosen_(count, -1) {
    for (std::size_t i = 0; i < links.size(); ++i)
      heap_[links[i].to] = heaps_.merge(heap_[links[i].to], static_cast<int>(i));
    seen_[root] = static_cast<int>(root);
  }

  std::vector<int> run() {
    for (std::uint32_t place = 0; place < seen_.size(); ++place)
      climb(place);
    unfold();
    return std::move(chosen_);
  }

private:
  static constexpr int unseen = -1;

  /// Follows the cheapest links from `start` back until the root or a place seen before is met.
  void climb(std::uint32_t start) {
    std::uint32_t at = groups_.find(start);
    std::vector<int> links;
    std::vector<std::uint32_t> path;
    while (seen_[at] == unseen) {
      const int least = heap_[at];
      if (least == LinkHeaps::empty) { // no path leads here
        path.push_back(at);
        seen_[at] = static_cast<int>(start);
        break;
      }
      heaps_.lower(heap_[at], heaps_.leastCost(least));
      heap_[at] = heaps_.withoutLeast(least);
      links.push_back(least);
      path.push_back(at);
      seen_[at] = static_cast<int>(start);
      at = groups_.find(links_[static_cast<std::size_t>(least)].from);
      if (seen_[at] == static_cast<int>(start)) at = drawTogether(at, links, path);
    }
    for (const int link : links)
      chosen_[groups_.find(links_[static_cast<std::size_t>(link)].to)] = link;
  }

  /// Makes one place of the cycle that `path` ends with, which closes at `at`.
  std::uint32_t drawTogether(std::uint32_t at, std::vector<int>& links,
                             std::vector<std::uint32_t>& path) {
    Cycle cycle;
    cycle.time = groups_.time();
    int heap = LinkHeaps::empty;
    for (std::uint32_t member = path.back();; member = path.back()) {
      heap = heaps_.merge(heap, heap_[member]);
      cycle.links.push_back(links.back());
      path.pop_back();
      links.pop_back();
      const bool isLast = member == at;
      groups_.join(at, member);
      if (isLast) break;
    }
    const std::uint32_t place = groups_.find(at);
    heap_[place] = withoutInner(heap, place);
    seen_[place] = unseen;
    cycle.place = place;
    cycles_.push_back(std::move(cycle));
    return place;
  }

  /// Drops links that start within the place they lead to.
  int withoutInner(int heap, std::uint32_t place) {
    while (heap != LinkHeaps::empty &&
           groups_.find(links_[static_cast<std::size_t>(heap)].from) == place)
      heap = heaps_.withoutLeast(heap);
    return heap;
  }

  /// Opens the cycles, the last first, where the link that was chosen enters them.
  void unfold() {
    for (auto cycle = cycles_.rbegin(); cycle != cycles_.rend(); ++cycle) {
      const int entry = chosen_[cycle->place];
      groups_.rewind(cycle->time);
      if (entry < 0) continue; // no path leads here
      for (const int link : cycle->links)
        chosen_[groups_.find(links_[static_cast<std::size_t>(link)].to)] = link;
      if (entry >= 0) chosen_[groups_.find(links_[static_cast<std::size_t>(entry)].to)] = entry;
    }
  }

  const std::vector<DirectedLink>& links_;
  LinkHeaps heaps_;
  Groups groups_;
  std::vector<int> heap_;   // by place
  std::vector<int> seen_;   // by place: from where
  std::vector<int> chosen_; // by place: the link to it
  std::vector<Cycle> cycles_;
};

/// Drops links that start at places that no path leads to from the root.
void keepReached(std::uint32_t root, const std::vector<DirectedLink>& links,
                 std::vector<int>& chosen) {
  std::vector<std::vector<std::uint32_t>> carried(chosen.size());
  for (std::uint32_t place = 0; place < chosen.size(); ++place)
    if (chosen[place] >= 0)
      carried[links[static_cast<std::size_t>(chosen[place])].from].push_back(place);
  std::vector<bool> isReached(chosen.size(), false);
  std::vector<std::uint32_t> stack = {root};
  while (!stack.empty()) {
    const std::uint32_t place = stack.back();
    stack.pop_back();
    isReached[place] = true;
    for (const std::uint32_t next : carried[place])
      if (!isReached[next]) stack.push_back(next);
  }
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (!isReached[i]) chosen[i] = -1;
}

} // namespace

std::vector<int> minimumArborescence(std::uint32_t count, std::uint32_t root,
                                     const std::vector<DirectedLink>& links) {
  std::vector<DirectedLink> useful;
  std::vector<int> places; // in `links`
  for (std::size_t i = 0; i < links.size(); ++i)
    if (links[i].to != root && links[i].to != links[i].from) {
      useful.push_back(links[i]);
      places.push_back(static_cast<int>(i));
    }
  std::vector<int> chosen = Search(count, root, useful).run();
  keepReached(root, useful, chosen);
  for (int& link : chosen)
    if (link >= 0) link = places[static_cast<std::size_t>(link)];
  return chosen;
}

} // namespace espalier
