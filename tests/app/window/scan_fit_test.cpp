#include "app/window/files/load_files.h"
#include "app/window/files/scan_fit.h"
#include "app/window/frame/action_set.h"
#include "core/io/formats.h"
#include "core/skeleton/edits.h"
#include "tests/app/window/window_fixture.h"
#include "ui/panels/message_banner.h"

#include <QAction>

#include <algorithm>
#include <gmock/gmock.h>
#include <vector>

namespace espalier {
namespace {

/// The axes of the plant that writeScan() scans, with nodes 0.1 m apart.
Skeleton axes() {
  Skeleton plant;
  std::vector<NodeId> trunk;
  for (int i = 0; i <= 20; ++i)
    trunk.push_back(plant.add({.position = {0, 0, 0.1 * i},
                               .parent = i == 0 ? std::nullopt : std::optional(trunk.back())}));
  const auto addBranch = [&](int from, const Eigen::Vector3d& to) {
    NodeId parent = trunk[static_cast<std::size_t>(from)];
    const Eigen::Vector3d start = plant[parent].position;
    for (int i = 1; i <= 10; ++i)
      parent = plant.add({.position = start + 0.1 * i * (to - start),
                          .parent = parent,
                          .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
  };
  addBranch(10, {0.8, 0, 1.6});
  addBranch(12, {-0.7, 0.1, 1.9});
  addBranch(8, {0.1, 0.7, 1.3});
  return plant;
}

/// A scan and its true structure, as files.
struct ScanFitTest : test::WindowTest {
  const Skeleton truth = axes();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(); // of the points [m]

  void SetUp() override {
    const PointCloud cloud = readPoints(toPath(writeScan("tree.xyz"))).value;
    for (Eigen::Index i = 0; i < cloud.size(); ++i)
      mean += cloud.position(i) / static_cast<double>(cloud.size());
  }
  /// The true structure times `factor`, then moved by `shift`, as a file.
  QString writeTree(double factor, const Eigen::Vector3d& shift) {
    Skeleton plant = truth;
    for (const NodeId id : plant.ids())
      plant.setPosition(id, factor * plant[id].position + shift);
    writeStructure(toPath(path("tree.mtg")), plant);
    return path("tree.mtg");
  }
  [[nodiscard]] std::string message() { return window().banner().text().toStdString(); }
  /// Height of the lowest node, whatever its id in the file.
  [[nodiscard]] static double lowest(const Skeleton& plant) {
    double height = 1e9;
    for (const NodeId id : plant.ids())
      height = std::min(height, plant[id].position.z());
    return height;
  }
};

TEST_F(ScanFitTest, OffersToMoveAStructureAboutTheMeanOfTheScanInAnyOrder) {
  const QString structure = writeTree(1, -mean);
  const QString scan = path("tree.xyz");
  for (const QList<QStringList>& order :
       {QList<QStringList>{{scan}, {structure}}, {{structure}, {scan}}, {{structure, scan}}}) {
    restart();
    for (const QStringList& paths : order)
      open(paths);
    ASSERT_TRUE(window().banner().isVisible());
    EXPECT_THAT(message(), testing::MatchesRegex(
                               "tree.mtg seems to be centered on the mean of the scan: move it by "
                               "\\([-.0-9]+, [-.0-9]+, [.0-9]+\\) m\\?"));
    const Skeleton before = document().skeleton();
    clickButton("banner_action");
    EXPECT_NEAR(lowest(document().skeleton()), lowest(truth), 1e-5);
    EXPECT_EQ(document().undoStack().count(), 1);
    EXPECT_EQ(action("undo").text(), "&Undo: Move structure onto the scan");
    document().undoStack().undo();
    EXPECT_EQ(document().skeleton(), before);
  }
}

TEST_F(ScanFitTest, LooksAtThePlantOnceItLiesOnTheScan) {
  open({path("tree.xyz"), writeTree(1, -mean)});
  const double before = view().camera().distance;
  clickButton("banner_action");
  EXPECT_LT(view().camera().distance, before) << "nothing lies apart any more";
}

TEST_F(ScanFitTest, LeavesAStructureWhereItIsIfAsked) {
  open({path("tree.xyz"), writeTree(1, -mean)});
  const Skeleton before = document().skeleton();
  clickButton("dismiss");
  EXPECT_FALSE(window().banner().isVisible());
  EXPECT_EQ(document().skeleton(), before);
  EXPECT_FALSE(document().isModified());
}

TEST_F(ScanFitTest, KeepsTheOfferWhileThePlantIsEdited) {
  open({path("tree.xyz"), writeTree(1, -mean)});
  const NodeId root = document().skeleton().roots().front();
  document().edit("Radius", [&](SkeletonEditor& editor) { editor.setRadius(root, 1); });
  ASSERT_TRUE(window().banner().isVisible());
  clickButton("banner_action");
  EXPECT_EQ(document().undoStack().count(), 2);
}

TEST_F(ScanFitTest, SaysNothingOfAStructureThatFits) {
  open({path("tree.xyz"), writeTree(1, {0, 0, 0})});
  EXPECT_FALSE(window().banner().isVisible()) << message();
}

TEST_F(ScanFitTest, OpensAStructureInAnotherUnitWithANote) {
  open({path("tree.xyz")});
  open({writeTree(1000, {0, 0, 0})});
  EXPECT_FALSE(window().banner().isError());
  EXPECT_THAT(message(), testing::MatchesRegex(
                             "tree.mtg does not lie on tree.xyz: it is [0-9]+ times as large; is "
                             "it of another plant, or in another unit\\?"));
  EXPECT_EQ(document().skeleton().size(), truth.size());
}

TEST_F(ScanFitTest, OpensAStructureOutsideOfTheScanWithANote) {
  open({path("tree.xyz"), writeTree(1, {100, 0, 0})});
  EXPECT_EQ(message(), "tree.mtg lies outside of tree.xyz: is it of another plant?");
  EXPECT_EQ(document().skeleton().size(), truth.size());
}

TEST_F(ScanFitTest, ComparesNothingWithTheScanThatAnotherOneReplaces) {
  open({path("tree.xyz"), writeTree(1, {100, 0, 0})});
  open({writeScan("other.xyz")});
  EXPECT_FALSE(window().banner().isVisible()) << message();
}

TEST(Misfit, IsDescribedInASentence) {
  EXPECT_EQ(describe({.size = 266.4}, "pine.mtg", "palm.las"),
            "pine.mtg does not lie on palm.las: it is 266 times as large; is it of another plant, "
            "or in another unit?");
  EXPECT_EQ(describe({.size = 0.001}, "pine.mtg", "palm.las"),
            QString::fromUtf8("pine.mtg does not lie on palm.las: it is 1\u202f000 times as small; "
                              "is it of another plant, or in another unit?"));
}

} // namespace
} // namespace espalier
