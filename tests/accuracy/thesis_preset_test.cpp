// What the settings of the thesis reach, beside the automatic result that was published with it.
#include "core/evaluate/comparison.h"
#include "core/evaluate/traits/wood_amounts.h"
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/presets.h"
#include "tests/support/shared_data.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {
namespace {

Reconstruction reconstructed(const PointCloud& cloud, const char* preset) {
  return Pipeline().run(std::make_shared<const PointCloud>(cloud), presetNamed(preset)->options);
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Greatest radius over the median one of the tips.
double footToTip(const Skeleton& skeleton) {
  double foot = 0;
  std::vector<double> tips;
  for (const NodeId id : skeleton.ids()) {
    foot = std::max(foot, skeleton[id].radius);
    if (skeleton.children(id).empty()) tips.push_back(skeleton[id].radius);
  }
  return foot / medianOf(tips);
}

double woodVolume(const Skeleton& skeleton) {
  return woodAmounts(skeleton, {}).whole.volume;
}

/// Radii fall from foot to tip.
Skeleton taperedWood(const std::filesystem::path& scan) {
  const Skeleton result = *reconstructed(readPoints(scan).value, "thesis").skeleton;
  EXPECT_GT(footToTip(result), 4);
  return result;
}

/// And the wood has about the volume of the default's.
void expectTaperedWood(const std::filesystem::path& scan) {
  const double share = woodVolume(taperedWood(scan)) /
                       woodVolume(*reconstructed(readPoints(scan).value, "default").skeleton);
  EXPECT_GT(share, 0.5);
  EXPECT_LT(share, 2);
}

// And it has about the volume of the wood that the thesis itself has of this scan.
TEST(ThesisPreset, TapersThePine) {
  ESPALIER_SHARED_FILE(scan, "puu1/scan.ply");
  ESPALIER_SHARED_FILE(published, "puu1/thesis_automatic.mtg");
  const double share =
      woodVolume(taperedWood(scan)) / woodVolume(readStructure(published).value.skeleton);
  EXPECT_GT(share, 0.6);
  EXPECT_LT(share, 1.6);
}

TEST(ThesisPreset, TapersAWalnutBranch) {
  ESPALIER_SHARED_FILE(scan, "A3B4/scan.asc");
  expectTaperedWood(scan);
}

TEST(ThesisPreset, TapersATree) {
  ESPALIER_SHARED_FILE(scan, "las/tree.las");
  expectTaperedWood(scan);
}

// Radii that are all the same have over four times the volume of this wood.
TEST(ThesisPreset, TapersASimulatedTreeAsItsTruth) {
  const test::SimulatedPlant& plant = test::simulatedTree();
  const Reconstruction result = reconstructed(plant.cloud, "thesis");
  EXPECT_TRUE(notesOf(result).empty());
  EXPECT_GT(footToTip(*result.skeleton), 4);
  EXPECT_GT(footToTip(*result.skeleton), footToTip(plant.truth) / 4)
      << "tips are thinner than the points are apart";
  const double share = woodVolume(*result.skeleton) / woodVolume(plant.truth);
  EXPECT_GT(share, 0.5);
  EXPECT_LT(share, 2);
}

// As released, the automatic result lies 49 mm too low: compare() lays one on the other.
//
// It reaches G .908, T .777, F .914. Radii fall by 14.4 times from foot to tips, those published by
// 16.0: 1.5 times either way is what the foot and the tips may each be off by a fifth. Over the
// wood that both have they are 1.33 times as thick, 2.4 mm in the mean, concordance .77; half of
// the point spacing is what a scan shows, and one radius for all nodes has concordance 0.
TEST(ThesisPreset, OfThePineAgreesWithThePublishedAutomaticResult) {
  ESPALIER_SHARED_FILE(scan, "puu1/scan.ply");
  ESPALIER_SHARED_FILE(automatic, "puu1/thesis_automatic.mtg");
  const Skeleton published = readStructure(automatic).value.skeleton;
  const Reconstruction result = reconstructed(readPoints(scan).value, "thesis");
  EXPECT_TRUE(notesOf(result).empty());
  const Comparison comparison =
      compare(*result.skeleton, published, {.tolerance = {.distances = {20}}}); // [mm]
  EXPECT_GE(comparison.authors.geometric, 0.88);
  EXPECT_GE(comparison.authors.structural, 0.70);
  EXPECT_GE(comparison.tolerance.scores.front().f(), 0.88);
  const double ratio = footToTip(*result.skeleton) / footToTip(published);
  EXPECT_GT(ratio, 1 / 1.5);
  EXPECT_LT(ratio, 1.5);
  EXPECT_GT(comparison.radii.compared, 0.9 * comparison.resultWood.whole.length);
  EXPECT_LT(std::abs(comparison.radii.meanError), result.scale.spacing / 2);
  EXPECT_GT(comparison.radii.concordance, 0.5);
  EXPECT_LT(comparison.resultWood.whole.volume, 2 * comparison.referenceWood.whole.volume)
      << "it is a fifth longer";
}

// The published result itself reaches G .901, T .820, F .912; this G .929, T .816, F .909, with
// 1132 segments where the expert has 1116 and the published result 1506.
TEST(ThesisPreset, OfThePineIsAsNearToTheExpertAsThePublishedAutomaticResult) {
  ESPALIER_SHARED_FILE(scan, "puu1/scan.ply");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Reconstruction result = reconstructed(readPoints(scan).value, "thesis");
  const Comparison comparison = compare(*result.skeleton, readStructure(expert).value.skeleton,
                                        {.tolerance = {.distances = {20}}}); // [mm]
  EXPECT_GE(comparison.authors.geometric, 0.90);
  EXPECT_GE(comparison.authors.structural, 0.80);
  EXPECT_GE(comparison.tolerance.scores.front().f(), 0.89);
}

} // namespace
} // namespace espalier
