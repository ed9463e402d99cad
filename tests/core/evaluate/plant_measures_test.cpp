#include "core/base/error.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/comparison_json.h"
#include "core/evaluate/plant_measures.h"
#include "core/evaluate/registration/registration.h"
#include "core/evaluate/trait_rows.h"
#include "core/evaluate/traits_json.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <stop_token>

namespace espalier {
namespace {

constexpr LightOptions someLight{.pixels = 128};

/// A trunk of 2 with a branch of 1 to the side from its middle, a node each tenth, all 0.05 thick.
Skeleton branched() {
  Skeleton plant = test::stick(21, 0.1);
  NodeId last{10};
  for (int i = 1; i <= 10; ++i)
    last = plant.add({.position = {0.1 * i, 0, 1},
                      .radius = 0.05,
                      .parent = last,
                      .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 0.05);
  return plant;
}

double valueOf(const std::vector<TraitRow>& rows, const std::string& label) {
  for (const TraitRow& row : rows)
    if (row.label == label) return row.value;
  throw std::out_of_range(label);
}

TEST(PlantMeasures, AreThoseOfAComparison) {
  const Skeleton plant = branched();
  ComparisonOptions beside;
  beside.light = someLight;
  const auto both = toJson(compare(plant, test::stick(30, 0.1), beside));
  const auto alone = toJson(plantMeasures(plant, {.light = someLight}));
  EXPECT_EQ(alone["traits"], both["traits"]["result"]);
  EXPECT_EQ(alone["wood"]["whole"], both["wood"]["result"]["whole"]);
  EXPECT_EQ(alone["wood"]["by_order"], both["wood"]["result"]["by_order"]);
  // There it is laid on the reference, which moves it by less than a pixel.
  EXPECT_NEAR(alone["light"]["star"].get<double>(), both["light"]["result"]["star"].get<double>(),
              0.005);
  EXPECT_EQ(alone["light"]["directions"].size(), 46U);
}

TEST(PlantMeasures, AreKnownOnPaper) {
  const PlantMeasures measures =
      plantMeasures(branched(), {.breastHeight = 1.3, .light = someLight});
  const std::vector<TraitRow> rows = traitRows(measures);
  EXPECT_EQ(valueOf(rows, "tips"), 2);
  EXPECT_EQ(valueOf(rows, "segments"), 3);
  EXPECT_EQ(valueOf(rows, "orders"), 2);
  EXPECT_NEAR(valueOf(rows, "length"), 3, 1e-9);
  EXPECT_NEAR(valueOf(rows, "height"), 2, 1e-9);
  EXPECT_NEAR(valueOf(rows, "crown base"), 1, 1e-9);
  EXPECT_NEAR(valueOf(rows, "branching angle, order 1"), M_PI / 2, 1e-9);
  EXPECT_NEAR(valueOf(rows, "volume"), 3 * M_PI * 0.05 * 0.05, 1e-9);
  EXPECT_NEAR(valueOf(rows, "diameter at 1.3 m"), 0.1, 1e-9);
  // Thin cylinders: 2 r l sin(angle) of 2 pi r l, so below 1 / pi, from whichever direction.
  EXPECT_GT(valueOf(rows, "STAR"), 0.1);
  EXPECT_LT(valueOf(rows, "STAR"), 1 / M_PI);
}

TEST(PlantMeasures, LeaveOutWhatThereIsNot) {
  const auto has = [](const std::vector<TraitRow>& rows, const std::string& label) {
    return std::ranges::count(rows, label, &TraitRow::label) > 0;
  };
  const PlantMeasures measures = plantMeasures(test::stick(5));
  EXPECT_FALSE(has(traitRows(measures), "divergence")) << "of no branch";
  EXPECT_FALSE(has(traitRows(measures), "STAR")) << "not asked for";
  EXPECT_FALSE(has(traitRows(measures), "diameter at 1.3 m"));
  EXPECT_EQ(measures.stemMissing, "the unit of the lengths is not known");
  EXPECT_EQ(plantMeasures(test::stick(2), {.breastHeight = 1.3}).stemMissing,
            "the stem of the plant does not rise that high");
  Skeleton thin = test::stick(5);
  for (const NodeId id : thin.ids())
    thin.setRadius(id, 0);
  const PlantMeasures ofThin = plantMeasures(thin, {.light = someLight});
  EXPECT_FALSE(ofThin.light);
  ASSERT_EQ(ofThin.warnings.size(), 1U);
  EXPECT_THAT(inEnglish(ofThin.warnings.front()), testing::HasSubstr("no radii"));
}

// Turned by a right hand's turn from the axis that is up to z, all but the box is as before.
TEST(PlantMeasures, FollowTheAxisThatIsUp) {
  const Skeleton plant = branched();
  const auto expected = toJson(plantMeasures(plant, {.breastHeight = 1.3, .light = someLight}));
  for (const UpAxis up : {UpAxis::x, UpAxis::y}) {
    Skeleton lying = plant; // along x, or along y
    for (const NodeId id : plant.ids()) {
      const Eigen::Vector3d at = plant[id].position;
      lying.setPosition(id, up == UpAxis::x ? Eigen::Vector3d(at.z(), at.x(), at.y())
                                            : Eigen::Vector3d(at.x(), at.z(), -at.y()));
    }
    const Skeleton upright = standing(lying, up);
    for (const NodeId id : plant.ids())
      EXPECT_LT((upright[id].position - plant[id].position).norm(), 1e-12);
    EXPECT_EQ(toJson(plantMeasures(lying, {.up = up, .breastHeight = 1.3, .light = someLight})),
              expected);
    EXPECT_NE(toJson(plantMeasures(lying, {.breastHeight = 1.3})), expected);
  }
}

// Tips without a radius are cones, as many files have them.
TEST(PlantMeasures, WarnOfWoodWithoutRadii) {
  Skeleton plant = test::stick(5);
  const std::vector<NodeId> ids = plant.ids();
  plant.setRadius(ids.back(), 0);
  EXPECT_TRUE(plantMeasures(plant).warnings.empty());
  plant.setRadius(ids[ids.size() - 2], 0);
  const PlantMeasures ofPart = plantMeasures(plant, {.light = someLight});
  ASSERT_EQ(ofPart.warnings.size(), 1U);
  EXPECT_EQ(inEnglish(ofPart.warnings.front()),
            "25 % of the length has no radii: volume, areas, diameters and light lack that wood; "
            "estimate radii first");
  for (const NodeId id : ids)
    plant.setRadius(id, 0);
  const PlantMeasures ofNone = plantMeasures(plant);
  ASSERT_EQ(ofNone.warnings.size(), 1U);
  EXPECT_THAT(inEnglish(ofNone.warnings.front()), testing::StartsWith("the plant has no radii"));
}

TEST(PlantMeasures, WarnOfSeveralTrees) {
  Skeleton two = test::stick(5);
  const NodeId foot = two.add({.position = {3, 0, 0}, .radius = 0.1});
  two.add({.position = {3, 0, 1}, .radius = 0.1, .parent = foot});
  const PlantMeasures measures = plantMeasures(two);
  ASSERT_EQ(measures.warnings.size(), 1U);
  EXPECT_THAT(inEnglish(measures.warnings.front()),
              testing::HasSubstr("2 separate trees, measured as one"));
}

TEST(PlantMeasures, RefuseWhatHasNoSizeAndStopOnDemand) {
  EXPECT_THROW(plantMeasures(Skeleton()), Error);
  EXPECT_THROW(plantMeasures(test::stick(1)), Error);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(plantMeasures(branched(), {.light = someLight}, Progress(stop.get_token(), {})),
               Cancelled);
}

TEST(NumbersOfAPlant, AreATableToo) {
  const auto rows = tableOf(toJson(plantMeasures(test::stick(5))));
  EXPECT_THAT(rows.front(), testing::ElementsAre("name", "value"));
  EXPECT_THAT(rows, testing::Contains(testing::ElementsAre("traits.length", "4.0")));
}

} // namespace
} // namespace espalier
