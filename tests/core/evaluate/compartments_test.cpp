#include "core/evaluate/compartments.h"
#include "core/evaluate/traits_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numbers>

namespace espalier {
namespace {

constexpr double pi = std::numbers::pi;

/// A trunk 2 high of radius 0.1, of a growth unit G and a leafless one S above it, that bears a
/// branch of two edges, each 1 long, of radius 0.05: of an axis A at the coarser scale.
Skeleton tree() {
  Skeleton plant;
  const NodeId root =
      plant.add({.position = {0, 0, 0},
                 .radius = 0.1,
                 .entities = {{.scale = 2, .symbol = "T"}, {.scale = 3, .symbol = "G"}}});
  const NodeId middle = plant.add({.position = {0, 0, 1},
                                   .radius = 0.1,
                                   .parent = root,
                                   .entities = {{.scale = 3, .symbol = "G"}}});
  plant.add({.position = {0, 0, 2},
             .radius = 0.1,
             .parent = middle,
             .entities = {{.scale = 3, .symbol = "S"}}});
  const NodeId branch =
      plant.add({.position = {1, 0, 1},
                 .radius = 0.05,
                 .parent = middle,
                 .edge = EdgeType::branching,
                 .entities = {{.scale = 2, .symbol = "A"}, {.scale = 3, .symbol = "G"}}});
  plant.add(
      {.position = {2, 0, 1}, .radius = 0.05, .parent = branch}); // of no vertex: as its parent
  return plant;
}

std::vector<CompartmentTable> tablesOf(const WoodDensity& density) {
  return compartments(plantMeasures(tree(), {.density = density}));
}

/// The only table of a kind, and of a scale.
CompartmentTable oneOfKind(const std::vector<CompartmentTable>& tables, CompartmentTable::Kind kind,
                           int scale = 0) {
  for (const CompartmentTable& table : tables)
    if (table.kind == kind && table.scale == scale) return table;
  ADD_FAILURE() << "there is no such table";
  return {};
}

const WoodDensity heavy{.perCubicMeter = 500, .meters = 0.01}; // of a plant in cm

TEST(Compartments, AreLengthVolumeAndBiomassByOrder) {
  const CompartmentTable table = oneOfKind(tablesOf(heavy), CompartmentTable::Kind::order);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].name, "0");
  EXPECT_DOUBLE_EQ(table.rows[0].wood.length, 2);
  EXPECT_NEAR(table.rows[0].wood.volume, 2 * pi * 0.01, 1e-12);
  ASSERT_TRUE(table.rows[0].biomass);
  EXPECT_NEAR(*table.rows[0].biomass, 2 * pi * 0.01 * 1e-6 * 500, 1e-15);
  EXPECT_DOUBLE_EQ(table.rows[1].wood.length, 2);
}

TEST(Compartments, AreByDiameterUpToTheGreatest) {
  const CompartmentTable table = oneOfKind(tablesOf({}), CompartmentTable::Kind::diameter);
  ASSERT_EQ(table.rows.size(), 6U);
  EXPECT_FALSE(table.rows.front().from);
  EXPECT_DOUBLE_EQ(*table.rows.front().upTo, 0.2 / 32);
  EXPECT_DOUBLE_EQ(*table.rows.back().from, 0.1);
  EXPECT_FALSE(table.rows.back().upTo);
  EXPECT_DOUBLE_EQ(table.rows.back().wood.length, 2) << "the trunk";
  EXPECT_DOUBLE_EQ(table.rows[4].wood.length, 2) << "the branch is 0.1 thick from its beginning";
  EXPECT_FALSE(table.rows.back().biomass) << "no density is assumed";
}

// An edge is of the vertex that its upper node belongs to.
TEST(Compartments, AreByTheClassesOfEachScale) {
  const std::vector<CompartmentTable> tables = tablesOf({});
  const CompartmentTable axes = oneOfKind(tables, CompartmentTable::Kind::mtgClass, 2);
  ASSERT_EQ(axes.rows.size(), 2U);
  EXPECT_EQ(axes.rows[0].name, "A");
  EXPECT_DOUBLE_EQ(axes.rows[0].wood.length, 2);
  EXPECT_EQ(axes.rows[1].name, "T");
  EXPECT_DOUBLE_EQ(axes.rows[1].wood.length, 2);
  const CompartmentTable units = oneOfKind(tables, CompartmentTable::Kind::mtgClass, 3);
  ASSERT_EQ(units.rows.size(), 2U);
  EXPECT_EQ(units.rows[0].name, "G");
  EXPECT_DOUBLE_EQ(units.rows[0].wood.length, 3);
  EXPECT_EQ(units.rows[1].name, "S");
  EXPECT_DOUBLE_EQ(units.rows[1].wood.length, 1);
}

TEST(Compartments, SumUpToThePlant) {
  const PlantMeasures measures = plantMeasures(tree(), {.density = heavy});
  for (const CompartmentTable& table : compartments(measures)) {
    double length = 0;
    double biomass = 0;
    for (const Compartment& row : table.rows) {
      length += row.wood.length;
      biomass += row.biomass.value_or(0);
    }
    EXPECT_NEAR(length, measures.wood.whole.length, 1e-12);
    EXPECT_NEAR(biomass, heavy.biomass(measures.wood.whole), 1e-15);
  }
}

TEST(Compartments, OfAPlantWithoutRadiiAndClassesAreByOrderAlone) {
  Skeleton bare;
  const NodeId root = bare.add({.position = {0, 0, 0}});
  bare.add({.position = {0, 0, 1}, .parent = root});
  EXPECT_EQ(compartments(plantMeasures(bare)).size(), 1U);
}

TEST(Compartments, StandInTheNumbersOfThePlant) {
  const auto json = toJson(plantMeasures(tree(), {.density = heavy}));
  EXPECT_EQ(json["wood"]["by_class"][0]["class"], "A");
  EXPECT_EQ(json["wood"]["by_class"][0]["scale"], 2);
  EXPECT_EQ(json["biomass"]["density"], 500);
  EXPECT_EQ(json["biomass"]["by_class"].size(), 4U);
  EXPECT_TRUE(toJson(plantMeasures(tree()))["biomass"].is_null());
}

} // namespace
} // namespace espalier
