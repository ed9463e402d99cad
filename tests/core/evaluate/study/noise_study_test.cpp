#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/evaluate/study/noise_study.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

namespace espalier {
namespace {

double meanOf(const NoisePoint& point, const std::string& key) {
  return point.scores.at(key).mean;
}

/// With radii that fall with the height.
Skeleton thickBush() {
  Skeleton plant = test::bush();
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 0.2 - 0.01 * plant[id].position.z());
  return plant;
}

TEST(NoiseStudy, FindsThatErrorsRiseWithNoise) {
  const NoiseStudy study =
      noiseStudy(thickBush(), {.series = {{Perturbation::position, {0.1, 0.3, 1}}}, .repeats = 2});
  const std::vector<NoisePoint>& points = study.curves[0].points;
  for (const char* score :
       {"missed_length", "invented_length", "barcode", "substantial_to_reference",
        "substantial_to_result", "radius_root_mean_square"})
    for (std::size_t i = 1; i < points.size(); ++i)
      EXPECT_GT(meanOf(points[i], score), meanOf(points[i - 1], score)) << score;
  EXPECT_LT(meanOf(points[2], "concordance"), meanOf(points[0], "concordance"));
}

// Pruning invents nothing, and spurs miss nothing.
TEST(NoiseStudy, SeparatesWhatIsMissedFromWhatIsInvented) {
  const NoiseStudy study = noiseStudy(
      thickBush(),
      {.series = {{Perturbation::prune, {0.5}}, {Perturbation::spurs, {0.5}}}, .repeats = 2});
  const NoisePoint& pruned = study.curves[0].points[0];
  const NoisePoint& spurred = study.curves[1].points[0];
  EXPECT_GT(meanOf(pruned, "missed_length"), 0.1);
  EXPECT_NEAR(meanOf(pruned, "invented_length"), 0, 1e-12);
  EXPECT_EQ(meanOf(pruned, "substantial_to_reference"), 0);
  EXPECT_GT(meanOf(pruned, "substantial_to_result"), 0);
  EXPECT_GT(meanOf(spurred, "invented_length"), 0.1);
  EXPECT_NEAR(meanOf(spurred, "missed_length"), 0, 1e-12);
}

// Only the authors' Hausdorff distance of nodes may notice that they lie elsewhere.
TEST(NoiseStudy, FindsThatRespacingChangesNothing) {
  const NoiseStudy study =
      noiseStudy(test::bush(), {.series = {{Perturbation::resample, {0.5, 0.25}}}, .repeats = 1});
  for (const NoisePoint& point : study.curves[0].points)
    for (const char* score :
         {"capped_geometric", "capped_structural", "f", "tips", "branchings", "diadem", "ways"})
      EXPECT_NEAR(meanOf(point, score), 1, 0.01) << score;
}

TEST(NoiseStudy, FindsThatScoresFallWithNoise) {
  const NoiseStudy study = noiseStudy(
      test::bush(),
      {.series = {{Perturbation::position, {0.1, 0.3, 1}}, {Perturbation::prune, {0.1, 0.4, 0.9}}},
       .repeats = 2});
  for (const char* score : {"f", "capped_geometric", "diadem", "ways"})
    for (const NoiseCurve& curve : study.curves)
      for (std::size_t i = 1; i < curve.points.size(); ++i)
        EXPECT_LT(meanOf(curve.points[i], score), meanOf(curve.points[i - 1], score)) << score;
}

TEST(NoiseStudy, LaysShiftedPlantsOnTheReferenceIfAsked) {
  const auto scoreOf = [](bool registers) {
    const NoiseStudy study =
        noiseStudy(test::bush(),
                   {.series = {{Perturbation::shift, {2}}}, .repeats = 1, .registers = registers});
    return meanOf(study.curves[0].points[0], "f");
  };
  EXPECT_GT(scoreOf(true), 0.99);
  EXPECT_LT(scoreOf(false), 0.8);
}

TEST(NoiseStudy, IsTheSameOnAnyNumberOfThreads) {
  const NoiseOptions options{.series = {{Perturbation::position, {0.5}}}, .repeats = 3};
  const auto many = toTable(noiseStudy(test::bush(), options));
  const ThreadLimit one(1);
  EXPECT_EQ(toTable(noiseStudy(test::bush(), options)), many);
}

TEST(NoiseStudy, ReturnsTheScatterOfThePlants) {
  const NoiseStudy study =
      noiseStudy(test::bush(), {.series = {{Perturbation::prune, {0.5}}}, .repeats = 3, .seed = 8});
  std::vector<double> single;
  for (const std::uint64_t seed : {8U, 9U, 10U})
    single.push_back(
        studyScores(perturbed(test::bush(), Perturbation::prune, 0.5, seed), test::bush())
            .at("geometric"));
  const double mean = (single[0] + single[1] + single[2]) / 3;
  double squares = 0;
  for (const double score : single)
    squares += (score - mean) * (score - mean);
  const ScoreSpread& found = study.curves[0].points[0].scores.at("geometric");
  EXPECT_NEAR(found.mean, mean, 1e-12);
  EXPECT_NEAR(found.deviation, std::sqrt(squares / 2), 1e-12);
}

TEST(NoiseStudy, RefusesWhatLeavesNothing) {
  EXPECT_THROW((void)noiseStudy({}), Error);
  EXPECT_THROW((void)noiseStudy(test::fork(2), {.series = {{Perturbation::shorten, {-1}}}}), Error);
}

TEST(NoiseStudy, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)noiseStudy(test::fork(2), {}, Progress(source.get_token(), {})), Cancelled);
}

} // namespace
} // namespace espalier
