#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/evaluate/noise_study.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

namespace espalier {
namespace {

double meanOf(const NoisePoint& point, Score score) {
  return point.mean[static_cast<std::size_t>(score)];
}

TEST(AgreementScores, HaveANameEach) {
  EXPECT_EQ(scoreNames().size(), static_cast<std::size_t>(Score::radiusRootMeanSquare) + 1);
  EXPECT_EQ(agreementScores(test::fork(2), test::fork(2)).size(), scoreNames().size());
  EXPECT_EQ(scoreNames()[static_cast<std::size_t>(Score::diadem)], "diadem");
  EXPECT_EQ(scoreNames()[static_cast<std::size_t>(Score::f)], "f");
}

/// With radii that fall with the height.
Skeleton thickBush() {
  Skeleton plant = test::bush();
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 0.2 - 0.01 * plant[id].position.z());
  return plant;
}

TEST(AgreementScores, OfAPlantWithItselfAreOneAndErrorsZero) {
  const std::vector<double> scores = agreementScores(thickBush(), thickBush());
  for (std::size_t i = 0; i < scores.size(); ++i)
    EXPECT_NEAR(scores[i], isError(static_cast<Score>(i)) ? 0 : 1, 1e-12) << scoreNames()[i];
}

TEST(NoiseStudy, FindsThatErrorsRiseWithNoise) {
  const NoiseStudy study =
      noiseStudy(thickBush(), {.series = {{Perturbation::position, {0.1, 0.3, 1}}}, .repeats = 2});
  const std::vector<NoisePoint>& points = study.curves[0].points;
  for (const Score score :
       {Score::missedLength, Score::inventedLength, Score::barcode, Score::substantialToReference,
        Score::substantialToResult, Score::radiusRootMeanSquare})
    for (std::size_t i = 1; i < points.size(); ++i)
      EXPECT_GT(meanOf(points[i], score), meanOf(points[i - 1], score))
          << scoreNames()[static_cast<std::size_t>(score)];
  EXPECT_LT(meanOf(points[2], Score::concordance), meanOf(points[0], Score::concordance));
}

// Pruning invents nothing, and spurs miss nothing.
TEST(NoiseStudy, TellsWhatIsMissedFromWhatIsInvented) {
  const NoiseStudy study = noiseStudy(
      thickBush(),
      {.series = {{Perturbation::prune, {0.5}}, {Perturbation::spurs, {0.5}}}, .repeats = 2});
  const NoisePoint& pruned = study.curves[0].points[0];
  const NoisePoint& spurred = study.curves[1].points[0];
  EXPECT_GT(meanOf(pruned, Score::missedLength), 0.1);
  EXPECT_NEAR(meanOf(pruned, Score::inventedLength), 0, 1e-12);
  EXPECT_EQ(meanOf(pruned, Score::substantialToReference), 0);
  EXPECT_GT(meanOf(pruned, Score::substantialToResult), 0);
  EXPECT_GT(meanOf(spurred, Score::inventedLength), 0.1);
  EXPECT_NEAR(meanOf(spurred, Score::missedLength), 0, 1e-12);
}

// Only the authors' Hausdorff distance of nodes may notice that they lie elsewhere.
TEST(NoiseStudy, FindsThatRespacingChangesNothing) {
  const NoiseStudy study =
      noiseStudy(test::bush(), {.series = {{Perturbation::resample, {0.5, 0.25}}}, .repeats = 1});
  for (const NoisePoint& point : study.curves[0].points)
    for (const Score score : {Score::cappedGeometric, Score::cappedStructural, Score::f,
                              Score::tips, Score::branchings, Score::diadem, Score::ways})
      EXPECT_NEAR(meanOf(point, score), 1, 0.01) << scoreNames()[static_cast<std::size_t>(score)];
}

TEST(NoiseStudy, FindsThatScoresFallWithNoise) {
  const NoiseStudy study = noiseStudy(
      test::bush(),
      {.series = {{Perturbation::position, {0.1, 0.3, 1}}, {Perturbation::prune, {0.1, 0.4, 0.9}}},
       .repeats = 2});
  for (const Score score : {Score::f, Score::cappedGeometric, Score::diadem, Score::ways})
    for (const NoiseCurve& curve : study.curves)
      for (std::size_t i = 1; i < curve.points.size(); ++i)
        EXPECT_LT(meanOf(curve.points[i], score), meanOf(curve.points[i - 1], score))
            << scoreNames()[static_cast<std::size_t>(score)];
}

TEST(NoiseStudy, LaysShiftedPlantsOnTheReferenceIfAsked) {
  const auto scoreOf = [](bool registers) {
    const NoiseStudy study =
        noiseStudy(test::bush(),
                   {.series = {{Perturbation::shift, {2}}}, .repeats = 1, .registers = registers});
    return meanOf(study.curves[0].points[0], Score::f);
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

TEST(NoiseStudy, TellsTheScatterOfThePlants) {
  const NoiseStudy study =
      noiseStudy(test::bush(), {.series = {{Perturbation::prune, {0.5}}}, .repeats = 3, .seed = 8});
  const auto index = static_cast<std::size_t>(Score::geometric);
  std::vector<double> single;
  for (const std::uint64_t seed : {8U, 9U, 10U})
    single.push_back(agreementScores(perturbed(test::bush(), Perturbation::prune, 0.5, seed),
                                     test::bush())[index]);
  const double mean = (single[0] + single[1] + single[2]) / 3;
  double squares = 0;
  for (const double score : single)
    squares += (score - mean) * (score - mean);
  EXPECT_NEAR(study.curves[0].points[0].mean[index], mean, 1e-12);
  EXPECT_NEAR(study.curves[0].points[0].deviation[index], std::sqrt(squares / 2), 1e-12);
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
