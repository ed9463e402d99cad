// What the settings for plants with large leaves reach on seedlings, whose leaves have ends by the
// hundred where the plant has four.
#include "core/io/formats.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/presets.h"
#include "core/skeleton/branch_end.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>
#include <memory>
#include <string>
#include <vector>

namespace espalier {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

class LeavesPreset : public testing::TestWithParam<const char*> {};

/// Of all points of the scan: where they are thinned as needed, there are no such ends.
PipelineOptions ofAllPoints(PipelineOptions options) {
  options.set("thin.method=none");
  return options;
}

std::size_t endsOf(const std::shared_ptr<const PointCloud>& cloud, const PipelineOptions& options) {
  return branchEnds(*Pipeline().run(cloud, ofAllPoints(options)).skeleton).size();
}

TEST_P(LeavesPreset, LeavesFarFewerEndsThanTheLengthAlone) {
  ESPALIER_SHARED_FILE(scan, std::string("leafy/") + GetParam());
  const auto cloud = std::make_shared<const PointCloud>(readPoints(scan).value);
  PipelineOptions byLength;
  byLength.set("prune.method=spurs");
  const std::size_t alone = endsOf(cloud, byLength);
  ASSERT_GT(alone, 100U);
  EXPECT_LT(endsOf(cloud, {}), 3 * alone / 5);
  EXPECT_LT(endsOf(cloud, presetNamed("leaves")->options), alone / 6);
}

std::vector<std::string> notesOn(const std::filesystem::path& scan,
                                 const PipelineOptions& options) {
  return notesOf(Pipeline().run(std::make_shared<const PointCloud>(readPoints(scan).value),
                                ofAllPoints(options)));
}

TEST_P(LeavesPreset, IsProposedWhereMostEndsAreOfLeaves) {
  ESPALIER_SHARED_FILE(scan, std::string("leafy/") + GetParam());
  EXPECT_THAT(notesOn(scan, {}), Contains(HasSubstr("--preset leaves")));
  EXPECT_THAT(notesOn(scan, presetNamed("leaves")->options),
              Each(Not(HasSubstr("--preset leaves"))));
}

/// The graphs of the authors have four ends each, of which one is the root.
TEST_P(LeavesPreset, IsNotNeededWhereAsManyPointsAreUsedAsNeeded) {
  ESPALIER_SHARED_FILE(scan, std::string("leafy/") + GetParam());
  const auto cloud = std::make_shared<const PointCloud>(readPoints(scan).value);
  const Reconstruction result = Pipeline().run(cloud);
  constexpr std::size_t asTheAuthors = 3;
  const std::size_t tips = branchEnds(*result.skeleton).size();
  EXPECT_LE(tips, asTheAuthors + 2);
  EXPECT_GE(tips + 2, asTheAuthors);
}

TEST(LeavesPresetOfWood, IsNotProposed) {
  ESPALIER_SHARED_FILE(pine, "puu1/scan.ply");
  ESPALIER_SHARED_FILE(walnut, "A3B4/scan.asc");
  for (const auto& scan : {pine, walnut})
    EXPECT_THAT(notesOn(scan, {}), Each(Not(HasSubstr("--preset leaves")))) << scan;
}

INSTANTIATE_TEST_SUITE_P(Scans, LeavesPreset,
                         testing::Values("maize-03-13.ply", "tomato-03-08.ply"));

} // namespace
} // namespace espalier
