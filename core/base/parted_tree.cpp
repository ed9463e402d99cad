#include "core/base/parted_tree.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace espalier {
namespace {

constexpr std::size_t mostParts = 32;       // if they were even
constexpr std::size_t fewInPart = 8192;     // points: not worth dividing
constexpr std::size_t mostInPart = 1 << 15; // a tree of these is built within some 10 ms

/// Of the points, in the order of the tree; nanoflann 1.4 and 1.5 name them differently.
template <class Index> auto& numbersOf(Index& index) {
  if constexpr (requires { index.vAcc_; })
    return index.vAcc_;
  else
    return index.vAcc;
}

} // namespace

PartedTree::PartedTree(const Eigen::Matrix3Xf& points, const Progress& progress)
    : size_(static_cast<std::size_t>(points.cols())),
      places_(std::make_unique_for_overwrite<Place[]>(size_)) {
  if (size_ == 0) return;
  const auto copy = [&](Eigen::Index i) {
    places_[static_cast<std::size_t>(i)] = {points.col(i), static_cast<std::uint32_t>(i)};
  };
  parallelFor(points.cols(), copy, progress.part(0, 0), 1 << 14);
  PacedCheck check(progress);
  const Box all = boxOf(0, size(), check);
  parts_.push_back({.begin = 0, .end = size(), .room = all, .box = all});
  const std::size_t most = std::clamp(size() / mostParts, fewInPart, mostInPart);
  for (std::size_t first = 0; first < parts_.size();) { // level by level
    std::vector<std::size_t> divided;
    for (; first < parts_.size(); ++first)
      if (parts_[first].end - parts_[first].begin > most) divided.push_back(first);
    std::vector<std::array<Part, 2>> halvesOf(divided.size());
    const auto divide = [&](Eigen::Index i) {
      const auto k = static_cast<std::size_t>(i);
      halvesOf[k] = halves(parts_[divided[k]], progress);
    };
    parallelFor(static_cast<Eigen::Index>(divided.size()), divide, progress.part(0, 0), 1);
    for (std::size_t k = 0; k < divided.size(); ++k) {
      parts_[divided[k]].left = parts_.size();
      for (Part& half : halvesOf[k])
        parts_.push_back(std::move(half));
    }
  }
  buildParts(progress);
}

PartedTree::Box PartedTree::boxOf(std::size_t begin, std::size_t end, PacedCheck& check) const {
  Box box{places_[begin].position, places_[begin].position};
  for (std::size_t i = begin + 1; i < end; ++i) {
    box.low = box.low.min(places_[i].position.array());
    box.high = box.high.max(places_[i].position.array());
    check.after(4);
  }
  return box;
}

std::array<PartedTree::Part, 2> PartedTree::halves(Part& part, const Progress& progress) {
  PacedCheck check(progress);
  const Eigen::Array3f sides = part.room.high - part.room.low;
  const Eigen::Array3f spreads = part.box.high - part.box.low;
  float widest = -1;
  for (int axis = 0; axis < 3; ++axis) // of the longest sides that along which points lie widest
    if (sides[axis] > (1 - 0.00001F) * sides.maxCoeff() && spreads[axis] > widest) {
      widest = spreads[axis];
      part.axis = axis;
    }
  const int axis = part.axis;
  const float middle = (part.room.low[axis] + part.room.high[axis]) / 2;
  const float cut = std::clamp(middle, part.box.low[axis], part.box.high[axis]);
  const auto at = [&](std::size_t i) { return places_.get() + i; };
  const auto below = std::partition(at(part.begin), at(part.end), [&](const Place& place) {
    check.after(4);
    return place.position[axis] < cut;
  });
  const auto upTo = std::partition(below, at(part.end), [&](const Place& place) {
    check.after(4);
    return place.position[axis] <= cut;
  });
  // Points on the plane go to either side, so that the halves are as even as can be.
  const auto split = static_cast<std::size_t>(
      std::clamp(at(part.begin + (part.end - part.begin) / 2), below, upTo) - places_.get());
  std::array<Part, 2> halves = {Part{part.begin, split, part.room, boxOf(part.begin, split, check)},
                                Part{split, part.end, part.room, boxOf(split, part.end, check)}};
  halves[0].room.high[axis] = halves[1].room.low[axis] = cut;
  return halves;
}

void PartedTree::buildParts(const Progress& progress) {
  const auto build = [&](Eigen::Index i) {
    Part& part = parts_[static_cast<std::size_t>(i)];
    if (part.left != 0) return; // its halves are built
    part.tree = std::make_unique<Tree>(Places{
        .first = places_.get() + part.begin, .count = part.end - part.begin, .box = part.room});
    sortAsIn(*part.tree, part.begin);
  };
  parallelFor(static_cast<Eigen::Index>(parts_.size()), build, progress.part(0, 0), 1);
}

void PartedTree::sortAsIn(Tree& tree, std::size_t begin) {
  auto& numbers = numbersOf(tree.index);
  std::vector<Place> sorted;
  sorted.reserve(numbers.size());
  for (const std::uint32_t number : numbers)
    sorted.push_back(places_[begin + number]);
  std::iota(numbers.begin(), numbers.end(), 0U);
  std::ranges::copy(sorted, places_.get() + begin);
}

} // namespace espalier
