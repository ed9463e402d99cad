#include "core/base/spatial_index.h"

#include "core/base/parallel.h"
#include "core/base/parted_tree.h"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace espalier {
namespace {

// Results of searches, as nanoflann 1.4 and 1.5 both ask for them (they differ in their own).

/// Keeps the nearest points of a search of nanoflann's, of equally near ones those found first.
///
/// Each has a key that grows with its distance, then with when it was found. Keys are kept as the
/// doubles of the same bits, which sort alike: a new one goes to its place without a branch.
class NearestKept {
public:
  explicit NearestKept(std::size_t count) // > 0
      : count_(count), keys_((count + 1) / 2) {
    begin(std::numeric_limits<float>::max());
  }

  /// Forgets all; keeps no more but what is nearer than `squaredReach` [L^2].
  void begin(float squaredReach) {
    found_.clear();
    keys_.assign(keys_.size(), Two::Constant(keyOf(squaredReach, none)));
  }

  // As nanoflann asks for it.
  [[nodiscard]] float worstDist() const { return distanceOf(key(count_ - 1)); } // [L^2]
  [[nodiscard]] static bool full() { return true; }
  [[nodiscard]] std::size_t size() const { return found_.size(); }
  static void sort() {}
  bool addPoint(float squaredDistance, std::uint32_t index) {
    const double added = keyOf(squaredDistance, static_cast<std::uint32_t>(found_.size()));
    found_.push_back(index);
    double last = -1;        // before all others
    for (Two& own : keys_) { // each place keeps its own, takes the new one, or that before its own
      const Two before(last, own[0]);
      last = own[1];
      own = before.max(own.min(added));
    }
    return true;
  }

  /// Calls visit(index, squaredDistance) for each, the nearest first.
  template <class Visit> void forEach(const Visit& visit) const {
    for (std::size_t i = 0; i < count_; ++i) {
      const auto number = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(key(i)));
      if (number == none) return;
      visit(found_[number], distanceOf(key(i)));
    }
  }

private:
  using Two = Eigen::Array2d; // goes to its place in one step
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  static double keyOf(float squaredDistance, std::uint32_t number) {
    const std::uint64_t high = std::bit_cast<std::uint32_t>(squaredDistance);
    return std::bit_cast<double>(high << 32 | number);
  }
  static float distanceOf(double key) {
    return std::bit_cast<float>(
        static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(key) >> 32));
  }

  [[nodiscard]] double key(std::size_t i) const { return keys_[i / 2][i % 2]; }

  std::size_t count_;
  std::vector<Two> keys_;            // the nearest first
  std::vector<std::uint32_t> found_; // index, by number
};

/// Keeps the nearest accepted point of a search.
template <class Accepts> class NearestAccepted {
public:
  NearestAccepted(float squaredRadius, const Accepts& accepts)
      : worst_(squaredRadius), accepts_(accepts) {}

  bool addPoint(float squaredDistance, std::uint32_t index) {
    if (squaredDistance < worst_ && accepts_(index)) {
      worst_ = squaredDistance;
      found_ = Neighbor{index, squaredDistance};
    }
    return true;
  }
  [[nodiscard]] float worstDist() const { return worst_; }
  [[nodiscard]] static bool full() { return true; }
  [[nodiscard]] std::size_t size() const { return found_ ? 1 : 0; }
  void sort() const {}
  [[nodiscard]] const std::optional<Neighbor>& found() const { return found_; }

private:
  float worst_;
  const Accepts& accepts_;
  std::optional<Neighbor> found_;
};

/// Keeps the nearest points of a search that are not passed over.
struct NearestOfOthers : NearestKept {
  NearestOfOthers(std::size_t count, const std::vector<bool>& passed)
      : NearestKept(count), isPassed(passed) {}

  const std::vector<bool>& isPassed;

  bool addPoint(float squaredDistance, std::uint32_t index) {
    return isPassed[index] || NearestKept::addPoint(squaredDistance, index);
  }
};

/// Keeps every point of a search within a radius, unless it is passed over.
class Within {
public:
  Within(float squaredRadius, const std::vector<bool>& isPassed)
      : squaredRadius_(squaredRadius), isPassed_(isPassed) {
    found_.reserve(64); // memory once instead of in steps
  }

  bool addPoint(float squaredDistance, std::uint32_t index) {
    const bool isPassed = !isPassed_.empty() && isPassed_[index];
    if (squaredDistance <= squaredRadius_ && !isPassed) found_.push_back({index, squaredDistance});
    return true;
  }
  [[nodiscard]] float worstDist() const { return squaredRadius_; }
  [[nodiscard]] static bool full() { return true; }
  [[nodiscard]] std::size_t size() const { return found_.size(); }
  void sort() const {}
  [[nodiscard]] std::vector<Neighbor> take() { return std::move(found_); }

private:
  float squaredRadius_;
  const std::vector<bool>& isPassed_;
  std::vector<Neighbor> found_;
};

/// No point is farther from its nearest ones than one beside it, and that from its own. [L^2]
float squaredReachFrom(const NearestKept& ofOneBeside, float apart) {
  const float reach = std::sqrt(ofOneBeside.worstDist()) + apart;
  constexpr float rounding = 1e-4F;
  return std::min((1 + rounding) * reach * reach + std::numeric_limits<float>::min(),
                  std::numeric_limits<float>::max());
}

} // namespace

struct SpatialIndex::Tree {
  const Eigen::Matrix3Xf& points;
  PartedTree parts;
};

SpatialIndex::SpatialIndex(const Eigen::Matrix3Xf& points, const Progress& progress)
    : tree_(std::make_shared<const Tree>(Tree{points, PartedTree(points, progress)})) {}
SpatialIndex::SpatialIndex(std::shared_ptr<const Tree> tree) : tree_(std::move(tree)) {}
SpatialIndex::~SpatialIndex() = default;
SpatialIndex::SpatialIndex(SpatialIndex&&) noexcept = default;
SpatialIndex& SpatialIndex::operator=(SpatialIndex&&) noexcept = default;

Eigen::Index SpatialIndex::size() const {
  return static_cast<Eigen::Index>(tree_->parts.size());
}

SpatialIndex SpatialIndex::passingOver(std::vector<bool> points) const {
  assert(points.size() == tree_->parts.size());
  SpatialIndex index(tree_);
  index.isPassed_ = std::move(points);
  return index;
}

std::vector<Neighbor> SpatialIndex::nearest(const Eigen::Vector3f& place, int count) const {
  const auto total = tree_->parts.size();
  const auto wanted = std::min(static_cast<std::size_t>(std::max(count, 0)), total);
  if (wanted == 0) return {};
  const auto found = [&](auto kept) {
    tree_->parts.search(place, kept);
    std::vector<Neighbor> result;
    result.reserve(wanted);
    kept.forEach([&](std::uint32_t index, float squaredDistance) {
      result.push_back({index, squaredDistance});
    });
    return result;
  };
  return isPassed_.empty() ? found(NearestKept(wanted)) : found(NearestOfOthers(wanted, isPassed_));
}

std::vector<Neighbor> SpatialIndex::within(const Eigen::Vector3f& place, float radius) const {
  if (tree_->parts.size() == 0) return {};
  Within result(radius * radius, isPassed_);
  tree_->parts.search(place, result);
  return result.take();
}

template <class Accepts>
std::optional<Neighbor> SpatialIndex::nearestAccepted(const Eigen::Vector3f& place, float radius,
                                                      const Accepts& accepts) const {
  if (tree_->parts.size() == 0) return std::nullopt;
  const auto acceptsIt = [&](std::uint32_t point) {
    return (isPassed_.empty() || !isPassed_[point]) && accepts(point);
  };
  NearestAccepted result(radius * radius, acceptsIt);
  tree_->parts.search(place, result);
  return result.found();
}

std::optional<Neighbor> SpatialIndex::nearestOne(const Eigen::Vector3f& place, float radius) const {
  return nearestAccepted(place, radius, [](Eigen::Index) { return true; });
}

std::optional<Neighbor>
SpatialIndex::nearestIf(const Eigen::Vector3f& place, float radius,
                        const std::function<bool(Eigen::Index)>& accepts) const {
  return nearestAccepted(place, radius, accepts);
}

Eigen::Index SpatialIndex::othersPerPoint(int count) const {
  const auto total = static_cast<Eigen::Index>(tree_->parts.size());
  return std::min<Eigen::Index>(std::max(count, 0), std::max<Eigen::Index>(total - 1, 0));
}

/// Calls visit(point, rank, other, squaredDistance) for the nearest others of each point, those of
/// a point one after the other, the nearest first, of rank 0.
template <class Visit>
void SpatialIndex::forEachOther(Eigen::Index perPoint, const Visit& visit,
                                const Progress& progress) const {
  assert(isPassed_.empty());
  const auto wanted = static_cast<std::size_t>(perPoint) + 1; // the point itself comes along
  struct Last {
    NearestKept kept;
    Eigen::Index point = -2; // that it keeps the nearest of
  };
  oneapi::tbb::enumerable_thread_specific<Last> lasts([&] { return Last{NearestKept(wanted)}; });
  const auto place = [&](Eigen::Index point) { return tree_->points.col(point); };
  const auto findOthersOf = [&](Eigen::Index point) {
    auto& [kept, last] = lasts.local();
    kept.begin(last == point - 1 ? squaredReachFrom(kept, (place(point) - place(last)).norm())
                                 : std::numeric_limits<float>::max());
    last = point;
    tree_->parts.search(place(point), kept);
    Eigen::Index rank = 0;
    kept.forEach([&](std::uint32_t index, float squaredDistance) {
      if (index == static_cast<std::uint32_t>(point) || rank == perPoint) return;
      visit(point, rank++, index, squaredDistance);
    });
  };
  parallelFor(tree_->points.cols(), findOthersOf, progress);
}

NearestOthers SpatialIndex::nearestOthers(int count, const Progress& progress) const {
  NearestOthers result;
  result.perPoint = othersPerPoint(count);
  if (result.perPoint == 0) return result;
  result.indices.resize(tree_->parts.size() * static_cast<std::size_t>(result.perPoint));
  result.squaredDistances.resize(result.indices.size());
  const auto keep = [&](Eigen::Index point, Eigen::Index rank, std::uint32_t other,
                        float squaredDistance) {
    const auto at = static_cast<std::size_t>(point * result.perPoint + rank);
    result.indices[at] = other;
    result.squaredDistances[at] = squaredDistance;
  };
  forEachOther(result.perPoint, keep, progress);
  return result;
}

std::vector<float> SpatialIndex::squaredReaches(int count, const Progress& progress) const {
  std::vector<float> reaches(tree_->parts.size(), 0);
  const Eigen::Index perPoint = othersPerPoint(count);
  if (perPoint == 0) return reaches;
  const auto keep = [&](Eigen::Index point, Eigen::Index /*rank*/, std::uint32_t /*other*/,
                        float squaredDistance) { // the farthest comes last
    reaches[static_cast<std::size_t>(point)] = squaredDistance;
  };
  forEachOther(perPoint, keep, progress);
  return reaches;
}

} // namespace espalier
