#include "core/base/box_tree.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <ranges>
#include <utility>

namespace espalier {
namespace {

constexpr std::uint32_t boxesPerLeaf = 4;

} // namespace

BoxTree::BoxTree(std::vector<Eigen::AlignedBox3d> boxes, std::vector<std::uint32_t> groups)
    : boxes_(std::move(boxes)), groups_(std::move(groups)), order_(boxes_.size()) {
  assert(groups_.empty() || groups_.size() == boxes_.size());
  if (boxes_.empty()) return;
  std::iota(order_.begin(), order_.end(), 0U);
  parts_.push_back({{}, 0, static_cast<std::uint32_t>(boxes_.size())});
  for (std::uint32_t part = 0; part < parts_.size(); ++part)
    split(part);
}

std::vector<std::uint32_t> BoxTree::renumber() {
  const auto sorted = [&](const auto& values) {
    auto result = values;
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] = values[order_[k]];
    return result;
  };
  boxes_ = sorted(boxes_);
  groups_ = sorted(groups_);
  std::vector<std::uint32_t> before(order_.size());
  std::iota(before.begin(), before.end(), 0U);
  std::swap(before, order_);
  return before;
}

void BoxTree::split(std::uint32_t part) {
  const std::uint32_t begin = parts_[part].begin;
  const std::uint32_t end = parts_[part].end;
  Eigen::AlignedBox3d centers;
  for (std::uint32_t k = begin; k < end; ++k) {
    parts_[part].box.extend(boxes_[order_[k]]);
    centers.extend(boxes_[order_[k]].center());
  }
  const auto groupAt = [&](std::uint32_t k) { return groups_[order_[k]]; };
  const auto isOfFirst = [&](std::uint32_t k) { return groupAt(k) == groupAt(begin); };
  const auto all = std::views::iota(begin, end);
  if (!groups_.empty() && std::ranges::all_of(all, isOfFirst)) parts_[part].group = groupAt(begin);
  if (end - begin <= boxesPerLeaf) return;

  Eigen::Index axis = 0;
  centers.sizes().maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double aCenter = boxes_[a].center()[axis];
                     const double bCenter = boxes_[b].center()[axis];
                     return aCenter != bCenter ? aCenter < bCenter : a < b;
                   });
  parts_[part].left = static_cast<std::uint32_t>(parts_.size());
  parts_.push_back({{}, begin, middle});
  parts_.push_back({{}, middle, end});
}

} // namespace espalier
