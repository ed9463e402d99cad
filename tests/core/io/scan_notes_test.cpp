#include "core/io/scan_notes.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

RawPoints fork(int copies = 1) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  RawPoints raw;
  for (Eigen::Index i = 0; i < copies * points.cols(); ++i)
    raw.positions.emplace_back(points.col(i % points.cols()).cast<double>());
  return raw;
}

TEST(ScanNotes, SayNothingOfACleanScan) {
  EXPECT_THAT(scanNotes(PointCloud(fork()), "oak.xyz"), IsEmpty());
  EXPECT_THAT(scanNotes(PointCloud(), "oak.xyz"), IsEmpty());
}

TEST(ScanNotes, SayHowManyPointsLieFarOffAndHowFar) {
  RawPoints raw = fork();
  raw.positions.emplace_back(0, 0, -250);
  EXPECT_THAT(eachInEnglish(scanNotes(PointCloud(raw), "oak.xyz")),
              ElementsAre("oak.xyz: 1 point lies far from all others, 250 away: the step Clean "
                          "leaves it out, and spacing, size and view are those of the others"));
  raw.positions.emplace_back(0, 0, 1e6);
  raw.positions.emplace_back(40, 0, 1);
  EXPECT_THAT(
      eachInEnglish(scanNotes(PointCloud(raw), "oak.xyz")),
      ElementsAre("oak.xyz: 3 points lie far from all others, up to 999997 away: the step Clean "
                  "leaves them out, and spacing, size and view are those of the others"));
}

TEST(ScanNotes, SayHowManyPointsAreRepeated) {
  const std::string all = std::to_string(3 * test::forkCloud().cols());
  const std::string repeated = std::to_string(2 * test::forkCloud().cols());
  EXPECT_THAT(eachInEnglish(scanNotes(PointCloud(fork(3)), "oak.xyz")),
              ElementsAre("oak.xyz: " + repeated + " of " + all +
                          " points lie at the place of another: each place counts once"));
  RawPoints few = fork();
  few.positions.push_back(few.positions.front());
  EXPECT_THAT(scanNotes(PointCloud(few), "oak.xyz"), IsEmpty());
}

} // namespace
} // namespace espalier
