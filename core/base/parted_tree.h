#pragma once

#include "core/base/paced_check.h"
#include "core/base/progress.h"

#include <Eigen/Core>
#include <nanoflann.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace espalier {

/// A k-d tree of nanoflann's whose lower parts are built at once, on all threads.
///
/// The points are divided as nanoflann would divide them, until each part has few enough; a tree of
/// nanoflann's is built of each. So a search meets the points in the order in which it would meet
/// them in one tree, however many parts there are.
class PartedTree {
public:
  /// @param points 3 x N, finite; they are copied: 16 bytes each
  /// @throws Cancelled if `progress` asks to stop; it reports no progress
  explicit PartedTree(const Eigen::Matrix3Xf& points, const Progress& progress = {});

  [[nodiscard]] std::size_t size() const { return size_; }

  /// Adds the points near `place` to `result`, as a search of nanoflann's does. May run on many
  /// threads, each with a result of its own.
  template <class Result> void search(const Eigen::Vector3f& place, Result& result) const {
    if (size() > 0) searchIn(parts_.front(), place, result);
  }

private:
  struct Place {
    Eigen::Vector3f position; // [L]
    std::uint32_t column;     // of the points given
  };
  struct Box {
    Eigen::Array3f low, high; // [L]
    [[nodiscard]] float squaredDistance(const Eigen::Vector3f& place) const {
      const Eigen::Array3f out =
          (low - place.array()).max(place.array() - high).max(Eigen::Array3f::Zero());
      return out[0] * out[0] + out[1] * out[1] + out[2] * out[2]; // rounded as nanoflann rounds it
    }
  };

  /// Some of the points, as nanoflann asks for them.
  struct Places {
    const Place* first;
    std::size_t count;
    Box box;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return count; }
    [[nodiscard]] float kdtree_get_pt(std::size_t number, std::size_t row) const {
      return first[number].position.data()[row];
    }
    template <class Bounds> bool kdtree_get_bbox(Bounds& bounds) const {
      for (int axis = 0; axis < 3; ++axis)
        bounds[static_cast<std::size_t>(axis)] = {box.low[axis], box.high[axis]};
      return true;
    }
  };
  using Metric = nanoflann::L2_Simple_Adaptor<float, Places, float, std::uint32_t>;
  using Index = nanoflann::KDTreeSingleIndexAdaptor<Metric, Places, 3, std::uint32_t>;

  struct Tree {
    Places places;
    Index index;
    explicit Tree(Places own)
        : places(std::move(own)),
          index(3, places, nanoflann::KDTreeSingleIndexAdaptorParams(mostInLeaf)) {}
  };
  static constexpr std::size_t mostInLeaf = 12; // of nanoflann's: points

  struct Part {
    std::size_t begin, end; // in places_
    Box room;               // what is divided, between the planes that divided all before it
    Box box;                // of its points
    int axis = 0;           // along which it is divided
    std::size_t left = 0;   // its halves are parts left and left + 1; 0: it is not divided
    std::unique_ptr<Tree> tree = {}; // of nanoflann's, unless it is divided
  };

  /// Adds the points of a part to a result, by their columns.
  template <class Result> struct OfPart {
    Result& result;
    const Place* first;

    bool addPoint(float squaredDistance, std::uint32_t number) {
      return result.addPoint(squaredDistance, first[number].column);
    }
    [[nodiscard]] float worstDist() const { return result.worstDist(); }
    [[nodiscard]] bool full() const { return result.full(); }
    [[nodiscard]] std::size_t size() const { return result.size(); }
    void sort() const {}
  };

  template <class Result>
  void searchIn(const Part& part, const Eigen::Vector3f& place, Result& result) const {
    if (part.tree) {
      OfPart<Result> own{result, part.tree->places.first};
      part.tree->index.findNeighbors(own, place.data(), {});
      return;
    }
    const Part& left = parts_[part.left];
    const Part& right = parts_[part.left + 1];
    const float at = place[part.axis];
    const bool leftIsNearer = (at - left.box.high[part.axis]) + (at - right.box.low[part.axis]) < 0;
    searchIn(leftIsNearer ? left : right, place, result);
    const Part& other = leftIsNearer ? right : left;
    if (other.box.squaredDistance(place) <= result.worstDist()) searchIn(other, place, result);
  }

  [[nodiscard]] Box boxOf(std::size_t begin, std::size_t end, PacedCheck& check) const; // of places
  /// Divides the points of a part in two as nanoflann does.
  [[nodiscard]] std::array<Part, 2> halves(Part& part, const Progress& progress);
  void buildParts(const Progress& progress);
  void sortAsIn(Tree& tree, std::size_t begin); // a search reads what lies next to each other

  std::size_t size_;
  std::unique_ptr<Place[]> places_; // those of a part next to each other
  std::vector<Part> parts_;         // the whole first, each before its halves
};

} // namespace espalier
