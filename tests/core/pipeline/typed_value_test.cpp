#include "core/base/error.h"
#include "core/pipeline/pipeline_options.h"
#include "core/pipeline/preset.h"
#include "core/pipeline/typed_value.h"
#include "tests/core/io/samples.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::HasSubstr;
using State = TypedValue::State;

constexpr double millimeter = 1e-3;

/// What an option of the step `prune` is set to by this text.
Rule setTo(const std::string& text, double meters = 0) {
  PipelineOptions options;
  options.set("prune.length=" + inUnitOf(meters, text));
  return options.settings.at("prune").at("length");
}

std::string refusalOf(const std::string& assignment) {
  return test::errorOf([&] {
    PipelineOptions options;
    options.set(assignment);
    return 0;
  });
}

TEST(TypedValue, TakesUnitsWithABlankAndWithout) {
  for (const char* text : {"6spacings", "6 spacings", "6 sp", "6sp", "6 point spacings", " 6 SP ",
                           "6.0sp", "0.6e1 sp", "+6 spacing"})
    EXPECT_EQ(setTo(text), spacings(6)) << text;
  for (const char* text : {"0.02 heights", "0.02heights", "0.02h", "0,02 plant heights"})
    EXPECT_EQ(setTo(text), Rule{.heights = 0.02}) << text;
  for (const char* text : {"3 thicknesses", "3th", "3 thickness of thin wood"})
    EXPECT_EQ(setTo(text), thicknesses(3)) << text;
  for (const char* text : {"2 scatters", "2sc", "2 scatter", "2 scatters of points"})
    EXPECT_EQ(setTo(text), scatters(2)) << text;
  EXPECT_EQ(setTo("12.5"), fixedAt(12.5));
}

TEST(TypedValue, TurnsMetricLengthsIntoTheUnitOfTheScan) {
  EXPECT_DOUBLE_EQ(setTo("38mm", 1).fixed, 0.038);
  EXPECT_DOUBLE_EQ(setTo("3.8 cm", millimeter).fixed, 38);
  EXPECT_DOUBLE_EQ(setTo("0.038 m", millimeter).fixed, 38);
  EXPECT_DOUBLE_EQ(setTo("38", millimeter).fixed, 38) << "is in that of the scan";
}

TEST(TypedValue, SaysWhatToTypeWhereTheUnitOfTheScanIsNotKnown) {
  const std::string why = refusalOf("prune.length=38mm");
  EXPECT_THAT(why, HasSubstr("prune.length=38mm: the unit of the scan is not known"));
  EXPECT_THAT(why, HasSubstr("--unit"));
  EXPECT_THAT(why, HasSubstr("prune.length=38 for a scan in mm"));
  EXPECT_THAT(why, HasSubstr("prune.length=0.038 for one in m"));
}

TEST(TypedValue, RefusesOtherUnitsWithTheLineToType) {
  EXPECT_THAT(refusalOf("prune.length=6 inches"),
              HasSubstr("not '6 inches': write prune.length=6, or prune.length=6sp"));
  for (const char* text :
       {"", "sp", "six spacings", "6 spaces", "1e999", "nan", "inf", "1.2.3", "6 deg", "6sp 7sp"})
    EXPECT_NE(refusalOf(std::string("prune.length=") + text), "") << text;
  EXPECT_THAT(refusalOf("contract.neighbors=6sp"), HasSubstr("write contract.neighbors=6"));
  EXPECT_THAT(refusalOf("prune.length=6 scatterings"), HasSubstr("not '6 scatterings'"));
  EXPECT_THAT(refusalOf("contract.neighbors=6sc"), HasSubstr("write contract.neighbors=6"));
}

TEST(TypedValue, OfAnOptionThatNoMethodHasSaysSo) {
  PipelineOptions options;
  for (const char* typed : {"ground.metod=cloth", "ground.metod=6"})
    EXPECT_THAT([&] { options.set(typed); },
                testing::ThrowsMessage<Error>(
                    HasSubstr("method none of step ground has no option \"metod\": it has none; "
                              "choose a method by ground.method")))
        << typed;
}

// Where the unit of the scan is known, a length in mm is one, and never an angle or a share.
TEST(TypedValue, IsALengthForLengthsAlone) {
  const auto set = [](const std::string& assignment) {
    PipelineOptions options;
    options.methods["skeleton"] = "shortest_paths";
    options.set(assignment, millimeter);
    return options.settings.at("skeleton");
  };
  EXPECT_EQ(set("skeleton.spacing=3.8 cm").at("spacing"), fixedAt(38));
  EXPECT_EQ(set("skeleton.merge_angle=30 deg").at("merge_angle"), fixedAt(30));
  for (const std::string name : {"merge_angle", "power", "neighbors"}) {
    const std::string why = test::errorOf([&] { return set("skeleton." + name + "=30mm"); });
    EXPECT_THAT(why, HasSubstr("must be a number, not '30mm': write skeleton." + name + "=30"));
    EXPECT_THAT(why, testing::Not(HasSubstr("\n")));
  }
  std::istringstream in(R"({"skeleton": {"method": "shortest_paths", "power": "500mm"}})");
  EXPECT_THAT(test::errorOf([&] { return readPreset(in, "pine.json", 1).up; }),
              HasSubstr("pine.json, line 1: skeleton.power must be a number, not '500mm'"));
}

TEST(TypedValue, RecognizesWhatIsOnlyBegun) {
  for (const char* text : {"", "-", "6e", "6 s", "6 spac", "3c", "3 point sp"})
    EXPECT_EQ(typedValue(text).state, State::begun) << text;
  for (const char* text : {"6 k", "x", "6 spx", "--6"})
    EXPECT_EQ(typedValue(text).state, State::wrong) << text;
  EXPECT_EQ(typedValue("3cm").state, State::complete);
  EXPECT_EQ(typedValue("3 m").unit, ValueUnit::meters) << "though mm begins so, too";
  EXPECT_EQ(typedValue("30\u00b0").unit, ValueUnit::degrees);
}

TEST(TypedValue, IsTakenInPresetsToo) {
  std::istringstream in(R"({"prune": {"length": "38mm"}, "contract": {"radius": "6sp"}})");
  const PipelineOptions options = readPreset(in, "pine.json", 1);
  EXPECT_DOUBLE_EQ(options.settings.at("prune").at("length").fixed, 0.038);
  EXPECT_EQ(options.settings.at("contract").at("radius"), spacings(6));
  std::istringstream again(R"({"prune": {"length": "38mm"}})");
  EXPECT_THAT(test::errorOf([&] { return readPreset(again, "pine.json").up; }),
              HasSubstr("pine.json, line 1: prune.length=38mm: the unit of the scan is not known"));
}

} // namespace
} // namespace espalier
