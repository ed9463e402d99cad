// What the reconstruction reaches with no option given.
#include "core/base/parallel.h"
#include "core/evaluate/comparison.h"
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "core/skeleton/checks.h"
#include "tests/support/shared_data.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

Skeleton reconstructed(const std::filesystem::path& scan) {
  return *Pipeline().run(std::make_shared<const PointCloud>(readPoints(scan).value)).skeleton;
}

/// F within `distance` [L] of the reference.
double fWithin(double distance, const Comparison& comparison) {
  for (const ToleranceScore& score : comparison.tolerance.scores)
    if (score.distance == distance) return score.f();
  ADD_FAILURE() << "no score at " << distance;
  return 0;
}

/// The later revision has branches that the first structure lacks.
TEST(DefaultReconstruction, OfThePineOfTheThesisAgreesWithBothStructuresOfTheExpert) {
  ESPALIER_SHARED_FILE(scan, "puu1/scan.ply");
  ESPALIER_SHARED_FILE(first, "puu1/expert.mtg");
  ESPALIER_SHARED_FILE(revision, "puu1/expert_later_revision.mtg");
  const Skeleton result = reconstructed(scan);
  EXPECT_EQ(result.roots().size(), 1U);
  for (const auto& expert : {first, revision}) {
    const Comparison asItIs =
        compare(result, readStructure(expert).value.skeleton,
                {.registers = false, .tolerance = {.distances = {20}}}); // [mm]
    EXPECT_GE(asItIs.authors.geometric, 0.90);
    EXPECT_GE(asItIs.authors.structural, 0.80);
    EXPECT_GE(fWithin(20, asItIs), 0.85);
  }
}

/// Slips of a method; where wood turns or touches is the plant's, and worth a look only.
bool isSlip(const Finding& finding) {
  return finding.kind != Finding::Kind::sharpTurn && finding.kind != Finding::Kind::crossing &&
         finding.kind != Finding::Kind::loop;
}

/// One connected plant without slips, the same on one thread as on all.
void expectSoundPlant(const std::filesystem::path& scan) {
  const Skeleton onAll = reconstructed(scan);
  EXPECT_EQ(onAll.roots().size(), 1U);
  EXPECT_TRUE(std::ranges::none_of(check(onAll), isSlip));
  const ThreadLimit limit(1);
  EXPECT_EQ(reconstructed(scan), onAll);
}

TEST(DefaultReconstruction, OfThePineIsTheSameOnAnyNumberOfThreads) {
  ESPALIER_SHARED_FILE(scan, "puu1/scan.ply");
  expectSoundPlant(scan);
}

TEST(DefaultReconstruction, TakesAWalnutBranchInMeters) {
  ESPALIER_SHARED_FILE(scan, "A3B4/scan.asc");
  expectSoundPlant(scan);
}

TEST(DefaultReconstruction, TakesASmallBranch) {
  ESPALIER_SHARED_FILE(scan, "branch-demo/scan.ply");
  expectSoundPlant(scan);
}

TEST(DefaultReconstruction, FindsOneTreeInThreeFormats) {
  ESPALIER_SHARED_FILE(las, "las/tree.las");
  ESPALIER_SHARED_FILE(ply, "las/tree.ply");
  ESPALIER_SHARED_FILE(txt, "las/tree.txt");
  expectSoundPlant(las);
  // The three round coordinates differently, by up to 1 mm at points 27 mm apart. Where twigs
  // touch, that decides which one bears a branch: a tenth of the length may lie elsewhere, not
  // more.
  const Skeleton reference = reconstructed(las);
  for (const auto& other : {ply, txt}) {
    const Comparison comparison = compare(reconstructed(other), reference,
                                          {.registers = false, .tolerance = {.distances = {0.1}}});
    EXPECT_GE(fWithin(0.1, comparison), 0.85) << other;
  }
}

TEST(DefaultReconstruction, OfASimulatedTreeAgreesWithItsTruth) {
  const test::SimulatedPlant& plant = test::simulatedTree();
  const Reconstruction result =
      Pipeline().run(std::make_shared<const PointCloud>(plant.scan.points));
  const double near = 4 * result.scale.spacing;
  const Comparison comparison = compare(*result.skeleton, plant.truth,
                                        {.registers = false, .tolerance = {.distances = {near}}});
  EXPECT_GE(comparison.authors.geometric, 0.85);
  EXPECT_GE(comparison.authors.structural, 0.75);
  EXPECT_GE(fWithin(near, comparison), 0.93);
}

} // namespace
} // namespace espalier
