#include "core/base/parallel.h"
#include "core/base/parted_tree.h"
#include "core/base/random.h"

#include <gtest/gtest.h>

#include <stop_token>
#include <utility>

namespace espalier {
namespace {

/// The points of one tree of nanoflann's.
struct Columns {
  const Eigen::Matrix3Xf& points;

  [[nodiscard]] std::size_t kdtree_get_point_count() const {
    return static_cast<std::size_t>(points.cols());
  }
  [[nodiscard]] float kdtree_get_pt(std::size_t column, std::size_t row) const {
    return points(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
  }
  template <class Box> bool kdtree_get_bbox(Box& /*unused*/) const { return false; }
};
using Metric = nanoflann::L2_Simple_Adaptor<float, Columns, float, std::uint32_t>;
using OneTree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Columns, 3, std::uint32_t>;

/// Lists what a search meets within a radius, in the order in which it does.
struct Met {
  float squaredRadius;
  std::vector<std::pair<std::uint32_t, float>> found = {};

  bool addPoint(float squaredDistance, std::uint32_t column) {
    found.emplace_back(column, squaredDistance);
    return true;
  }
  [[nodiscard]] float worstDist() const { return squaredRadius; }
  [[nodiscard]] static bool full() { return true; }
  [[nodiscard]] std::size_t size() const { return found.size(); }
  void sort() const {}
};

/// Points along a line, with many at one place and many on one plane: no tree of them is even.
Eigen::Matrix3Xf unevenPoints(int count) {
  Random random(4);
  Eigen::Matrix3Xf points(3, count);
  for (int i = 0; i < count; ++i) {
    const double along = random.uniform() * random.uniform() * 100;
    points.col(i) = (Eigen::Vector3d(along, 0, 2) + random.direction()).cast<float>();
    if (i % 3 == 0) points.col(i) = points.col(i).array().round();
  }
  return points;
}

// Of equally near points those met first are kept: so the order counts, too.
TEST(PartedTree, MeetsPointsInTheOrderOfOneTree) {
  const Eigen::Matrix3Xf points = unevenPoints(100'000);
  const Columns columns{points};
  const OneTree one(3, columns, nanoflann::KDTreeSingleIndexAdaptorParams(12));
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    const PartedTree parted(points);
    for (Eigen::Index i = 0; i < points.cols(); i += 97) {
      Met expected{0.25F};
      one.findNeighbors(expected, points.col(i).data(), {});
      Met met{0.25F};
      parted.search(points.col(i), met);
      ASSERT_FALSE(met.found.empty());
      ASSERT_EQ(met.found, expected.found) << "point " << i << ", threads " << threads;
    }
  }
}

TEST(PartedTree, MeetsAllPointsThatLieAtOnePlace) {
  const Eigen::Matrix3Xf points = Eigen::Matrix3Xf::Constant(3, 50'000, 2.5F);
  Met met{1};
  PartedTree(points).search(points.col(0), met);
  EXPECT_EQ(met.found.size(), 50'000U);
}

TEST(PartedTree, MeetsNoneOfNoPoints) {
  const Eigen::Matrix3Xf none(3, 0);
  Met met{1};
  PartedTree(none).search(Eigen::Vector3f::Zero(), met);
  EXPECT_TRUE(met.found.empty());
}

TEST(PartedTree, StopsBeingBuiltWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(PartedTree(unevenPoints(100), Progress(source.get_token(), {})), Cancelled);
}

} // namespace
} // namespace espalier
