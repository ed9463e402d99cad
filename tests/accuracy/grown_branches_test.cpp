// What grows by command on a measured plant: the walnut branch whose proposals once turned back by
// 169 degrees and led through air, 21 mm from any point.
#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/pipeline/grow_branches.h"
#include "core/pipeline/regrow.h"
#include "core/reconstruct/trace.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/point_distances.h"
#include "tests/support/course.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

/// The scan of the walnut branch, and what the reconstruction makes of it with no option given.
class GrownOnWalnut : public testing::Test {
protected:
  void SetUp() override {
    ESPALIER_SHARED_FILE(scan, "A3B4/scan.asc");
    cloud_ = std::make_shared<const PointCloud>(readPoints(scan).value);
    spacing_ = pointSpacing(cloud_->positions());
    plant_ = *Pipeline().run(cloud_).skeleton;
  }

  void expectFollows(const std::vector<GrownBranch>& branches) const {
    Skeleton whole = plant_;
    SkeletonEditor editor(whole);
    (void)addGrown(editor, branches);
    (void)editor.commit();
    std::vector<NodeId> added = whole.ids();
    std::erase_if(added, [&](NodeId id) { return plant_.contains(id); });
    const test::Course course = test::courseOf(whole, added, *cloud_);
    EXPECT_GT(course.nodes, 0U);
    EXPECT_LE(course.sharpestTurn, 120 + 1e-6);
    EXPECT_LE(course.farthestNode, 1.5 * spacing_);
    EXPECT_LE(course.farthestOnEdge, 3 * spacing_);
  }

  std::shared_ptr<const PointCloud> cloud_;
  double spacing_ = 0;
  Skeleton plant_;
};

TEST_F(GrownOnWalnut, WhatIsMissingTurnsBackNowhereAndKeepsToThePoints) {
  expectFollows(grownFromUnexplained(plant_, cloud_));
}

TEST_F(GrownOnWalnut, EachClusterOfUnexplainedPointsMakesABranch) {
  PipelineOptions cutting; // so that branches are missing; the same plant whatever the defaults
  for (const char* setting : {"contract.radius=6.79075 spacings", "skeleton.neighbors=12",
                              "skeleton.bin_width=5.52716 spacings", "join.widest=10 spacings"})
    cutting.set(setting);
  cutting.set("prune.method=spurs");
  cutting.set("prune.length=30 spacings");
  plant_ = *Pipeline().run(cloud_, cutting).skeleton;
  const PointDistances distances(cloud_, spacing_, plant_);
  const std::vector<Finding> clusters = unexplainedClusters(distances, spacing_, {});
  ASSERT_FALSE(clusters.empty());
  for (const Finding& cluster : clusters) {
    const std::vector<GrownBranch> branches = grownBranches(plant_, cloud_, cluster.points);
    std::size_t nodes = 0;
    for (const GrownBranch& branch : branches)
      nodes += branch.part.size() - 1;
    EXPECT_GE(nodes, cluster.points.size() < 30 ? 1U : 2U)
        << "of " << cluster.points.size() << " points";
    SCOPED_TRACE(std::to_string(cluster.points.size()) + " points");
    expectFollows(branches);
  }
}

/// The axis behind a tip that carries nothing else, as far as two nodes from it.
std::optional<NodeId> belowTip(const Skeleton& plant, NodeId tip) {
  if (!plant.children(tip).empty()) return std::nullopt;
  NodeId at = tip;
  for (int i = 0; i < 2; ++i) {
    const std::optional<NodeId> parent = plant[at].parent;
    if (!parent || plant.children(*parent).size() > 1) return std::nullopt;
    at = *parent;
  }
  return at;
}

TEST_F(GrownOnWalnut, RegrowNearATipKeepsNodesAndTurnsBackNowhere) {
  int grown = 0;
  int fewer = 0;
  int met = 0;
  for (const NodeId tip : plant_.ids()) {
    const std::optional<NodeId> node = belowTip(plant_, tip);
    if (!node || ++met % 4 != 0) continue;
    Skeleton part;
    try {
      part = regrown(plant_, *node, cloud_);
    } catch (const Error&) { // what is there follows the points better
      continue;
    }
    ++grown;
    if (part.size() < 3) ++fewer;
    expectFollows({{*node, part}});
  }
  EXPECT_GT(grown, 5);
  EXPECT_LE(10 * fewer, grown) << "an edge in place of two nodes cuts a bend";
}

TEST_F(GrownOnWalnut, TracesKeepToThePoints) {
  const TraceGraph graph(cloud_);
  int met = 0;
  for (const NodeId tip : plant_.ids()) {
    if (!plant_.children(tip).empty() || ++met % 4 != 0) continue;
    NodeId from = tip;
    for (int i = 0; i < 12; ++i)
      from = plant_[from].parent.value_or(from);
    const Trace trace = graph
                            .between({plant_[from].position, true}, {plant_[tip].position, false},
                                     {.step = meanEdgeLength(plant_), .alternatives = 0})
                            .front();
    Skeleton line;
    std::optional<NodeId> last;
    for (std::size_t i = 0; i < trace.places.size(); ++i)
      last = line.add({.position = trace.places[i], .radius = trace.radii[i], .parent = last});
    std::vector<NodeId> added = line.ids();
    added.erase(added.begin());
    EXPECT_LE(test::courseOf(line, added, *cloud_).farthestNode, 1.5 * spacing_);
  }
}

} // namespace
} // namespace espalier
