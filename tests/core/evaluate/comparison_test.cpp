#include "core/base/error.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/comparison_json.h"
#include "core/graph/turn_upright.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/core/evaluate/tab_structure.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <gmock/gmock.h>
#include <memory>
#include <numbers>
#include <stop_token>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Traits, OfAForkAreKnownOnPaper) {
  const Traits fork = traits(test::fork(3));
  EXPECT_EQ(fork.nodes, 5U);
  EXPECT_EQ(fork.roots, 1U);
  EXPECT_EQ(fork.tips, 3U);
  EXPECT_EQ(fork.branchings, 1U);
  EXPECT_EQ(fork.segments, 4U);
  EXPECT_NEAR(fork.length, 1 + 3 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(fork.medianEdge, std::sqrt(2.0), 1e-12);
  EXPECT_THAT(fork.axesByOrder, ElementsAre(1, 2));
  EXPECT_NEAR(fork.lengthByOrder[0], 1 + std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(fork.lengthByOrder[1], 2 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(fork.extent.z(), 2, 1e-12);
}

TEST(Traits, CountASecondSuccessorAsAnAxisOfTheSameOrder) {
  Skeleton plant = test::fork(2);
  plant.setEdge(NodeId{3}, EdgeType::successor);
  EXPECT_THAT(traits(plant).axesByOrder, ElementsAre(2));
}

TEST(Traits, OfNothingAreZero) {
  const Traits none = traits({});
  EXPECT_EQ(none.nodes, 0U);
  EXPECT_EQ(none.length, 0);
  EXPECT_THAT(none.axesByOrder, IsEmpty());
}

TEST(Traits, OfTheExpertsPineAreTheKnownOnes) {
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Traits pine = traits(test::readTabStructure(expert));
  EXPECT_EQ(pine.nodes, 3358U);
  EXPECT_EQ(pine.tips, 564U);
  EXPECT_EQ(pine.segments, 1116U);
  EXPECT_NEAR(pine.length, 156485.72, 0.005);
  EXPECT_NEAR(pine.medianEdge, 44.4, 0.05);
  EXPECT_EQ(pine.axesByOrder.size(), 9U); // orders 0 to 8
}

TEST(LandmarkAgreement, PairsOneToOne) {
  const std::vector<Eigen::Vector3d> result = {{0, 0, 0}, {0.5, 0, 0}, {9, 0, 0}};
  const std::vector<Eigen::Vector3d> reference = {{0.1, 0, 0}, {20, 0, 0}};
  const auto agreement = landmarkAgreement(result, reference, 1);
  EXPECT_EQ(agreement.matched, 1U);
  EXPECT_NEAR(agreement.precision(), 1.0 / 3, 1e-12);
  EXPECT_NEAR(agreement.recall(), 1.0 / 2, 1e-12);
  EXPECT_NEAR(agreement.f(), 2.0 / 5, 1e-12);
}

TEST(LandmarkAgreement, CountsAPairAtTheVeryDistance) {
  EXPECT_EQ(landmarkAgreement({{0, 0, 0}}, {{0, 0, 2}}, 2).matched, 1U);
  EXPECT_EQ(landmarkAgreement({{0, 0, 0}}, {{0, 0, 0}}, 0).matched, 1U);
  EXPECT_EQ(landmarkAgreement({{0, 0, 0}}, {{0, 0, 2.001}}, 2).matched, 0U);
}

TEST(LandmarkAgreement, WithoutPlacesInventsNothingAndMissesNothing) {
  const auto none = landmarkAgreement({}, {}, 1);
  EXPECT_EQ(none.f(), 1);
  const auto missed = landmarkAgreement({}, {{0, 0, 0}}, 1);
  EXPECT_EQ(missed.precision(), 1);
  EXPECT_EQ(missed.recall(), 0);
}

TEST(Comparison, MeasuresHeightsAlongTheAxisThatPointsUp) {
  Skeleton upright = test::fork(3);
  for (const NodeId id : upright.ids())
    upright.setRadius(id, 0.05);
  ComparisonOptions options{.registers = false};
  options.breastHeight = 0.5;
  options.light = LightOptions{.pixels = 256};
  const Comparison expected = compare(upright, upright, options);
  ASSERT_TRUE(expected.stems.result);
  for (const UpAxis up : {UpAxis::x, UpAxis::y}) {
    const Skeleton file = moved(upright, Eigen::Isometry3d(turnUpright(up).transpose()));
    options.registration.up = up;
    const Comparison compared = compare(file, file, options);
    EXPECT_NEAR(compared.resultTraits.crown.height, 2, 1e-9);
    EXPECT_NEAR(compared.referenceTraits.crown.height, 2, 1e-9);
    ASSERT_TRUE(compared.stems.result);
    EXPECT_NEAR(*compared.stems.result, *expected.stems.result, 1e-9);
    EXPECT_EQ(compared.byPlace.byHeight.size(), expected.byPlace.byHeight.size());
    EXPECT_NEAR(compared.resultLight->star, expected.resultLight->star, 0.01);
  }
}

TEST(Comparison, OfAPlantWithItselfIsPerfect) {
  const Comparison comparison = compare(test::bush(), test::bush());
  EXPECT_EQ(comparison.authors.geometric, 1);
  EXPECT_EQ(comparison.authors.structural, 1);
  EXPECT_EQ(comparison.tolerance.scores[0].f(), 1);
  EXPECT_EQ(comparison.tips.f(), 1);
  EXPECT_EQ(comparison.branchings.f(), 1);
  ASSERT_TRUE(comparison.edit);
  EXPECT_EQ(comparison.edit->distance.distance, 0);
  EXPECT_THAT(comparison.warnings, IsEmpty());
}

TEST(Comparison, CountsEditsAfterRegistration) {
  const Skeleton bush = test::bush();
  const Skeleton result = test::shifted(bush, {0.5, 0.5, 0.5});
  const Comparison registered = compare(result, bush, {.edit = {.cost = EditCost::place}});
  EXPECT_NEAR(registered.edit->distance.distance, 0, 1e-2);
  const Comparison asIs =
      compare(result, bush, {.registers = false, .edit = {.cost = EditCost::place}});
  EXPECT_GT(asIs.edit->distance.distance, 0.5);
}

TEST(Comparison, LeavesEditsOutThatWouldTakeTooLong) {
  const Comparison comparison = compare(test::stick(5001), test::stick(5001),
                                        {.registers = false, .edit = {.unit = EditUnit::node}});
  EXPECT_FALSE(comparison.edit);
  EXPECT_THAT(eachInEnglish(comparison.warnings), ElementsAre(HasSubstr("5001 and 5001 parts")));
}

TEST(Comparison, MeasuresAfterRegistrationUnlessAskedNotTo) {
  const Skeleton bush = test::bush();
  const Skeleton result = test::shifted(bush, {0.5, 0.5, 0.5});
  const Comparison registered = compare(result, bush);
  EXPECT_NEAR(registered.tolerance.scores[0].f(), 1, 1e-3);
  EXPECT_EQ(registered.tips.f(), 1);
  EXPECT_THAT(eachInEnglish(registered.warnings),
              ElementsAre(HasSubstr("moved by (-0.5, -0.5, -0.5) to lie on it")));
  const Comparison asIs = compare(result, bush, {.registers = false});
  EXPECT_FALSE(asIs.registration);
  EXPECT_LT(asIs.tolerance.scores[0].f(), 0.5);
}

TEST(Comparison, SaysSoWhereUnitsSeemToDiffer) {
  const Comparison larger = compare(test::scaled(test::bush(), 1000), test::bush());
  EXPECT_THAT(
      eachInEnglish(larger.warnings),
      testing::Contains(HasSubstr("1000 times as large as the reference: it seems to be in mm, "
                                  "the reference in m; scale the plant by 0.001")));
  const Comparison smaller = compare(test::bush(), test::scaled(test::bush(), 100));
  EXPECT_THAT(eachInEnglish(smaller.warnings), testing::Contains(HasSubstr("100 times as small")));
  const Comparison other = compare(test::scaled(test::bush(), 30), test::bush());
  EXPECT_THAT(eachInEnglish(other.warnings),
              testing::Contains(HasSubstr("check that both are in the same unit")));
  for (const double factor : {4.0, 8.0}) { // as a branch may be beside its tree
    const Comparison near = compare(test::scaled(test::bush(), factor), test::bush());
    for (const std::string& warning : eachInEnglish(near.warnings))
      EXPECT_THAT(warning, testing::Not(HasSubstr("times as"))) << factor;
  }
}

TEST(Comparison, TakesASmallPartForNoPlantInAnotherUnit) {
  Skeleton stick; // a tenth as long as the bush, and straight
  const Eigen::Vector3d sides = traits(test::bush()).extent;
  const NodeId foot = stick.add({.radius = 0.01});
  stick.add({.position = {0, 0, sides.norm() / 10}, .radius = 0.01, .parent = foot});
  for (const std::string& warning : eachInEnglish(compare(stick, test::bush()).warnings))
    EXPECT_THAT(warning, testing::Not(HasSubstr("seems to be in")));
}

TEST(Comparison, SaysSoWhereTheTwoDoNotMeetOrAreSeveral) {
  const Skeleton far = test::shifted(test::fork(3), {500, 0, 0});
  EXPECT_THAT(eachInEnglish(compare(far, test::fork(3), {.registers = false}).warnings),
              ElementsAre(HasSubstr("hardly anything of the two lies within")));
  Skeleton two = test::fork(3);
  const NodeId second = two.add({.position = {5, 0, 0}});
  two.add({.position = {5, 0, 1}, .parent = second});
  EXPECT_THAT(eachInEnglish(compare(test::fork(3), two, {.registers = false}).warnings),
              ElementsAre(HasSubstr("the reference is of 2 separate trees")));
}

TEST(Comparison, OfDisjointPlantsFindsNothing) {
  const Comparison comparison =
      compare(test::shifted(test::fork(3), {500, 0, 0}), test::fork(3), {.registers = false});
  EXPECT_EQ(comparison.authors.geometric, 0);
  EXPECT_EQ(comparison.tolerance.scores.back().f(), 0);
  EXPECT_EQ(comparison.tips.f(), 0);
}

TEST(Comparison, RefusesAnEmptyStructureByName) {
  try {
    (void)compare(test::fork(2), {});
    FAIL() << "compared with nothing";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the reference has no nodes"));
  }
  EXPECT_THROW((void)compare({}, test::fork(2)), Error);
}

TEST(Comparison, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)compare(test::fork(3), test::fork(3), {}, Progress(source.get_token(), {})),
               Cancelled);
}

/// A thick stick, and a scan of all its way around but for its upper half, of which half was seen.
struct SeenStick {
  Skeleton plant = [] {
    Skeleton made = test::stick(21);
    for (const NodeId id : made.ids())
      made.setRadius(id, 1);
    return made;
  }();
  std::shared_ptr<const PointCloud> cloud = [] {
    RawPoints raw;
    for (int layer = 0; layer <= 200; ++layer)
      for (int sector = 0; sector < (layer <= 100 ? 16 : 8); ++sector) {
        const double angle = (sector + 0.5) * std::numbers::pi / 8;
        raw.positions.emplace_back(std::cos(angle), std::sin(angle), 0.1 * layer);
      }
    return std::make_shared<const PointCloud>(raw);
  }();
};

// Half is seen all around, half by half; an edge between two nodes of both counts as both.
TEST(Comparison, ListsRadiiByTheArcWhereverThePlantLay) {
  const SeenStick seen;
  Skeleton thicker = seen.plant;
  for (const NodeId id : thicker.ids())
    thicker.setRadius(id, 1.5);
  const Eigen::Vector3d off(3, 0, 0);
  for (const auto& [result, reference] :
       {std::pair(thicker, seen.plant), std::pair(thicker, test::shifted(seen.plant, off)),
        std::pair(test::shifted(thicker, off), seen.plant)}) {
    ComparisonOptions options;
    options.scan.cloud = seen.cloud;
    const Comparison comparison = compare(result, reference, options);
    ASSERT_EQ(comparison.radii.byArc.size(), 4U);
    EXPECT_EQ(comparison.radii.byArc[0].compared, 0);
    EXPECT_EQ(comparison.radii.byArc[1].compared, 0);
    EXPECT_NEAR(comparison.radii.byArc[2].compared, 10, 1);
    EXPECT_NEAR(comparison.radii.byArc[3].compared, 10, 1);
    EXPECT_NEAR(comparison.radii.byArc[3].meanError, 0.5, 1e-9);
    EXPECT_NEAR(comparison.radii.byArc[3].relativeRootMeanSquare, 0.5, 1e-9);
  }
}

TEST(Comparison, DoesNotCountPointsThatAreLeftOut) {
  const SeenStick seen;
  std::vector<Eigen::Index> upper;
  for (Eigen::Index i = 0; i < seen.cloud->size(); ++i)
    if (seen.cloud->position(i).z() > 9) upper.push_back(i);
  ComparisonOptions options{.registers = false};
  options.scan = {seen.cloud, PointSet::of(upper)};
  const Comparison comparison = compare(seen.plant, seen.plant, options);
  EXPECT_NEAR(comparison.radii.byArc[0].compared, 11, 1);
  EXPECT_NEAR(comparison.radii.byArc[3].compared, 9, 1);
  options.coverages = std::make_shared<const std::vector<double>>(21, 0.6);
  EXPECT_NEAR(compare(seen.plant, seen.plant, options).radii.byArc[2].compared, 20, 1e-9)
      << "as they were found before";
}

TEST(ComparisonJson, StatesStemsOrWhyNot) {
  const SeenStick seen;
  const auto known = toJson(
      compare(seen.plant, seen.plant, {.registers = false, .breastHeight = breastHeightIn("m")}));
  EXPECT_EQ(known["breast_height"]["height"], 1.3);
  EXPECT_EQ(known["breast_height"]["diameter"]["result"], 2.0);
  EXPECT_EQ(known["breast_height"]["error"], 0.0);
  EXPECT_TRUE(known["breast_height"]["missing"].is_null());
  EXPECT_EQ(known["radius"]["by_arc"], nlohmann::ordered_json::array()) << "without a scan";
  const auto unknown = toJson(compare(seen.plant, seen.plant, {.registers = false}));
  EXPECT_TRUE(unknown["breast_height"]["height"].is_null());
  EXPECT_EQ(unknown["breast_height"]["missing"], "the unit of the lengths is not known");
}

TEST(ComparisonJson, HasTheKeysThatScriptsRead) {
  Skeleton missing = test::fork(3);
  missing.erase(NodeId{4});
  const auto json = toJson(compare(missing, test::fork(3), {.registers = false}));
  EXPECT_EQ(json["authors"]["segments"]["result"], 3);
  EXPECT_EQ(json["authors"]["segments"]["reference"], 4);
  EXPECT_EQ(json["authors"]["matched"], 3);
  EXPECT_NEAR(json["authors"]["mapping"].get<double>(), 6.0 / 7, 1e-12);
  EXPECT_EQ(json["authors"]["structural"], 1.0);
  EXPECT_TRUE(json["authors"].contains("geometric"));
  for (const char* key : {"distance", "precision", "recall", "f"})
    EXPECT_TRUE(json["tolerance"][0].contains(key)) << key;
  EXPECT_EQ(json["shift"], nlohmann::ordered_json({0.0, 0.0, 0.0}));
  EXPECT_TRUE(json["registration"].is_null());
  EXPECT_EQ(json["traits"]["reference"]["tips"], 3);
  EXPECT_EQ(json["traits"]["matched_tips"]["recall"], 2.0 / 3);
}

TEST(ComparisonJson, StatesTheShiftThatWasFound) {
  const auto json = toJson(compare(test::shifted(test::bush(), {0, 0, 0.25}), test::bush()));
  EXPECT_NEAR(json["shift"][2].get<double>(), -0.25, 1e-6);
  EXPECT_NEAR(json["registration"]["residual_after"].get<double>(), 0, 1e-6);
}

// Figures found by others for 45 mm, with a shift and a way of pairing of their own.
TEST(Comparison, FindsTheKnownLandmarksOfTheAuthorsAutomaticResult) {
  ESPALIER_SHARED_FILE(automatic, "puu1/thesis_automatic.mtg");
  ESPALIER_SHARED_FILE(expert, "puu1/expert.mtg");
  const Comparison comparison = compare(test::readTabStructure(automatic),
                                        test::readTabStructure(expert), {.landmarkDistance = 45});
  EXPECT_NEAR(comparison.tips.precision(), 0.566, 0.01);
  EXPECT_NEAR(comparison.tips.recall(), 0.766, 0.01);
  EXPECT_NEAR(comparison.branchings.precision(), 0.568, 0.01);
  EXPECT_NEAR(comparison.branchings.recall(), 0.764, 0.01);
  EXPECT_THAT(eachInEnglish(comparison.warnings), ElementsAre(HasSubstr("49.4")));
}

} // namespace
} // namespace espalier
