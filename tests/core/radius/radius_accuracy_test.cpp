// The truth test of radii: simulated scans of several kinds of plants, measured over their own true
// skeletons, so that only the radii are judged.
#include "core/radius/fused_radii.h"
#include "core/radius/length_pipe_model.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace espalier {
namespace {

struct Kind {
  const char* name;
  Architecture architecture;
  int segments;
  int stations;
  std::optional<double> noise; // [L], none: common
};

void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A simulated scan and what is measured of it over the true skeleton.
struct Measured {
  Skeleton truth;
  PointCloud cloud;
  double spacing = pointSpacing(cloud.positions());
  AssignedPoints points{truth, cloud.positions(), cloud.origin()};
  std::vector<std::optional<FittedCylinder>> cylinders =
      cylindersAbout(truth, points, {.spacing = spacing});
  std::vector<MeasuredRadius> radii = cylinderRadii(cylinders, spacing);
  std::vector<MeasuredRadius> withThin = withThinRadii(truth, points, radii, pointError(cylinders));

  Measured(Skeleton plant, RawPoints raw) : truth(std::move(plant)), cloud(std::move(raw)) {}
  Measured(const Measured&) = delete;
  Measured& operator=(const Measured&) = delete;
  ~Measured() = default;
};

/// Made once per kind.
const Measured& measuredOf(const Kind& kind) {
  static std::map<std::string, std::unique_ptr<const Measured>> all;
  std::unique_ptr<const Measured>& one = all[kind.name];
  if (!one) {
    const Skeleton truth =
        growPlant({.architecture = kind.architecture, .height = 4, .segments = kind.segments}, 7);
    one = std::make_unique<const Measured>(
        truth,
        scan(truth, {.points = 20'000, .stations = kind.stations, .rangeNoise = kind.noise}, 7)
            .points);
  }
  return *one;
}

class RadiusAccuracy : public testing::TestWithParam<Kind> {
protected:
  /// Relative errors at the nodes that `counts` accepts.
  template <class Counts>
  [[nodiscard]] std::vector<double> errors(const std::vector<double>& radii,
                                           const Counts& counts) const {
    std::vector<double> result;
    for (const NodeId id : truth_.ids())
      if (radii[indexOf(id)] > 0 && counts(id))
        result.push_back(std::abs(radii[indexOf(id)] / truth_[id].radius - 1));
    return result;
  }

  const Measured& plant_ = measuredOf(GetParam());
  const Skeleton& truth_ = plant_.truth;
  const std::vector<MeasuredRadius>& measured_ = plant_.radii;
};

// Where coverage allows: where a cylinder was found in wood as thick as two spacings or more.
TEST_P(RadiusAccuracy, OfCylindersIsTenPercentWhereCoverageAllows) {
  std::vector<double> radii;
  for (const MeasuredRadius& each : measured_)
    radii.push_back(each.radius);
  const std::vector<double> found =
      errors(radii, [&](NodeId id) { return truth_[id].radius > 2 * plant_.spacing; });
  ASSERT_GT(found.size(), 10U);
  EXPECT_LE(medianOf(found), 0.10);
}

TEST_P(RadiusAccuracy, OfTheFusionIsTenPercentOfThickWoodAndHoldsOnTwigs) {
  const auto model = fittedLengthPipe(truth_, plant_.withThin);
  ASSERT_TRUE(model);
  const std::vector<double> radii =
      fusedRadii(truth_, plant_.withThin, radiiOf(truth_, *model),
                 {.modelSpread = std::clamp(model->spread, 0.08, 0.5)})
          .radii;
  EXPECT_LE(
      medianOf(errors(radii, [&](NodeId id) { return truth_[id].radius > 2 * plant_.spacing; })),
      0.10);
  EXPECT_LE(medianOf(errors(radii, [](NodeId) { return true; })), 0.2);
}

TEST_P(RadiusAccuracy, IsWhatTheDeviationSays) {
  std::vector<double> normalized;
  for (const NodeId id : truth_.ids())
    if (const MeasuredRadius& each = measured_[indexOf(id)]; each.radius > 0)
      normalized.push_back(std::abs(std::log(each.radius / truth_[id].radius)) / each.deviation);
  constexpr double ofNormalErrors = 0.67; // median of their absolute values
  EXPECT_LT(medianOf(normalized), 2 * ofNormalErrors);
}

INSTANTIATE_TEST_SUITE_P(
    Plants, RadiusAccuracy,
    testing::Values(Kind{"broadleaf", Architecture::broadleaf, 100, 4, std::nullopt},
                    Kind{"conifer", Architecture::conifer, 100, 4, std::nullopt},
                    Kind{"shrub", Architecture::shrub, 60, 4, std::nullopt},
                    Kind{"herb", Architecture::herb, 20, 4, std::nullopt},
                    Kind{"one_sided", Architecture::broadleaf, 100, 1, std::nullopt},
                    Kind{"noisy", Architecture::broadleaf, 100, 4, 0.004},
                    Kind{"exact", Architecture::broadleaf, 100, 4, 0.0}),
    [](const testing::TestParamInfo<Kind>& kind) { return kind.param.name; });

} // namespace
} // namespace espalier
