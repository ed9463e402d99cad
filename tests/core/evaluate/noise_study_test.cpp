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
  EXPECT_EQ(scoreNames().size(), static_cast<std::size_t>(Score::edge) + 1);
  EXPECT_EQ(agreementScores(test::fork(2), test::fork(2)).size(), scoreNames().size());
  EXPECT_EQ(scoreNames()[static_cast<std::size_t>(Score::diadem)], "diadem");
  EXPECT_EQ(scoreNames()[static_cast<std::size_t>(Score::f)], "f");
}

TEST(AgreementScores, OfAPlantWithItselfAreOne) {
  const std::vector<double> scores = agreementScores(test::bush(), test::bush());
  for (std::size_t i = 0; i < scores.size(); ++i)
    EXPECT_EQ(scores[i], 1) << scoreNames()[i];
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
