#include "core/base/error.h"
#include "core/pipeline/preset.h"
#include "core/pipeline/presets.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

PipelineOptions read(const std::string& text) {
  std::istringstream in(text);
  return readPreset(in);
}

TEST(Preset, IsReadAsItWasWritten) {
  PipelineOptions options;
  options.set("contract.radius=12.5");
  options.set("prune.length=3");
  options.set("clean.method=none");
  std::ostringstream out;
  writePreset(out, options);
  EXPECT_EQ(read(out.str()), options);
}

TEST(Preset, HoldsForAScanInAnotherUnit) {
  PipelineOptions options;
  options.set("contract.radius=76.25");
  options.set("contract.neighbors=9");
  options.set("prune.length=6sp");
  std::ostringstream out;
  writePreset(out, options, "mm");
  EXPECT_THAT(out.str(), testing::HasSubstr("\"radius\": \"76.25 mm\""));
  std::istringstream in(out.str());
  const PipelineOptions inMeters = readPreset(in, "mine.json", 1);
  EXPECT_DOUBLE_EQ(inMeters.settings.at("contract").at("radius").fixed, 0.07625);
  EXPECT_EQ(inMeters.settings.at("contract").at("neighbors"), fixedAt(9));
  EXPECT_EQ(inMeters.settings.at("prune").at("length"), spacings(6));
}

TEST(Preset, HasFlagsAsTrueAndFalse) {
  PipelineOptions options;
  options.set("contract.circles=yes");
  EXPECT_EQ(options.settings["contract"]["circles"], fixedAt(1));
  std::ostringstream out;
  writePreset(out, options);
  EXPECT_THAT(out.str(), testing::HasSubstr("\"circles\": true"));
  EXPECT_EQ(read(out.str()), options);
  EXPECT_EQ(read("{\"contract\": {\"circles\": \"no\"}}").settings["contract"]["circles"],
            fixedAt(0));
  EXPECT_THROW(read("{\"contract\": {\"circles\": 1}}"), Error);
  EXPECT_THROW(read("{\"contract\": {\"radius\": true}}"), Error);
}

TEST(Preset, HasLengthsThatFollowFromTheScan) {
  const PipelineOptions options =
      read(R"({"contract": {"radius": "6 spacings"}, "prune": {"length": "0.01 plant heights"}})");
  EXPECT_EQ(options.settings.at("contract").at("radius"), spacings(6));
  EXPECT_EQ(options.settings.at("prune").at("length"), Rule{.heights = 0.01});
  std::ostringstream out;
  writePreset(out, options);
  EXPECT_EQ(read(out.str()), options);
  EXPECT_THROW(read(R"({"contract": {"radius": "6 inches"}})"), Error);
  EXPECT_THROW(read(R"({"contract": {"radius": "six spacings"}})"), Error);
  EXPECT_THROW(read(R"({"contract": {"neighbors": "6 spacings"}})"), Error) << "a count";
}

TEST(Preset, HasLengthsThatFollowFromWoodAndScatter) {
  const PipelineOptions options =
      read(R"({"contract": {"radius": "2.5 thicknesses"}, "prune": {"length": "9 scatters"}})");
  EXPECT_EQ(options.settings.at("contract").at("radius"), thicknesses(2.5));
  EXPECT_EQ(options.settings.at("prune").at("length"), scatters(9));
  std::ostringstream out;
  writePreset(out, options);
  EXPECT_EQ(read(out.str()), options);
}

TEST(Preset, RuleIsTheSameLengthOnEachPlant) {
  PipelineOptions options;
  options.set("contract.radius=6 spacings");
  const Step& contract = stepNamed("contract");
  const Method& method = contract.methods.front();
  const auto radius = [&](const PlantScale& scale) {
    const std::vector<double> values = resolvedValues(contract, method, options, scale);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (method.options[i].name == "radius") return values[i];
    return 0.0;
  };
  EXPECT_DOUBLE_EQ(radius({.spacing = 0.005, .height = 4}), 0.03);
  EXPECT_DOUBLE_EQ(radius({.spacing = 5, .height = 4000}), 30);
  options.set("contract.radius=100 spacings");
  EXPECT_THROW((void)radius({.spacing = 5, .height = 4000}), Error) << "out of range";
}

TEST(Preset, ComeWithTheProgramForAnyPlant) {
  ASSERT_GE(presets().size(), 2U);
  EXPECT_EQ(presets().front().options, PipelineOptions()) << "the default chooses nothing";
  for (const NamedPreset& preset : presets()) {
    EXPECT_EQ(presetNamed(preset.name), &preset);
    EXPECT_NO_THROW(requireKnown(preset.options)) << preset.name;
    for (const auto& [step, values] : preset.options.settings)
      for (const auto& [name, rule] : values)
        for (const Option& option :
             methodNamed(stepNamed(step), preset.options.methods.contains(step)
                                              ? preset.options.methods.at(step)
                                              : stepNamed(step).methods.front().name)
                 .options) {
          if (option.name != name) continue;
          EXPECT_TRUE(option.kind != OptionKind::length || !rule.isFixed() || rule == fixedAt(0))
              << preset.name << ' ' << step << '.' << name << " is in some unit";
        }
  }
  EXPECT_EQ(presetNamed("magic"), nullptr);
}

TEST(Preset, OfTheThesisFollowsAForkInAnyUnit) {
  const PipelineOptions& options = presetNamed("thesis")->options;
  for (const float unit : {1.0F, 1000.0F}) {
    const Reconstruction plant =
        Pipeline().run(test::cloudOf(unit * test::forkCloud(), {0, 0, 0}), options);
    EXPECT_EQ(plant.skeleton->roots().size(), 1U);
    const std::vector<NodeId> ids = plant.skeleton->ids();
    const auto tips =
        std::ranges::count_if(ids, [&](NodeId id) { return plant.skeleton->children(id).empty(); });
    EXPECT_GE(tips, 2) << "two arms";
    EXPECT_LE(tips, 3) << "and a spur at most";
    for (const StepRecord& step : plant.steps) {
      if (step.step == "skeleton") {
        EXPECT_EQ(step.method, "point_tracking");
      }
    }
  }
}

TEST(Preset, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(read(""), Error);
  EXPECT_THROW(read("[1, 2]"), Error);
  EXPECT_THROW(read("{\"contract\": 5}"), Error);
  EXPECT_THROW(read("{\"flower\": {}}"), Error);
  EXPECT_THROW(read("{\"contract\": {\"method\": \"magic\"}}"), Error);
  EXPECT_THROW(read("{\"contract\": {\"radius\": \"wide\"}}"), Error);
}

/// Why a file is refused.
std::string refusal(const std::string& text) {
  try {
    std::istringstream in(text);
    (void)readPreset(in, "pine.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Preset, OfAFileIsRefusedWithTheLine) {
  using testing::StartsWith;
  EXPECT_THAT(refusal(""), StartsWith("pine.json, line 1: a preset is a JSON object"));
  EXPECT_THAT(refusal("{\n\"contract\": {\n\"radius\": 1,,\n}}"),
              StartsWith("pine.json, line 3: "));
  EXPECT_THAT(refusal("{\n\n\"flower\": {}\n}"),
              StartsWith("pine.json, line 3: there is no step \"flower\""));
  EXPECT_THAT(refusal("{\"contract\":\n5}"),
              StartsWith("pine.json, line 1: \"contract\" must hold"));
  EXPECT_THAT(
      refusal(
          "{\"clean\": {\"method\": \"none\"},\n \"contract\": {\n  \"method\":\n  \"magic\"}}"),
      StartsWith("pine.json, line 3: there is no method \"magic\""));
  EXPECT_THAT(refusal("{\"prune\": {\"length\": 1},\n\"contract\": {\n\"length\": 1}}"),
              StartsWith("pine.json, line 3: ")); // pruning has that option, contraction has not
  EXPECT_EQ(refusal("{\"contract\": {\n\"radius\": 12.5}}"), "");
  EXPECT_EQ(refusal("{\"contract\": {\n\"radius\": 1,\n\"radius\": 2}}"),
            "pine.json, line 2: \"radius\" stands here and once more: keep one of them");
  EXPECT_THAT(refusal("{\"prune\": {},\n\"clean\": {},\n\"prune\": {}}"),
              StartsWith("pine.json, line 1: \"prune\" stands here and once more"));
}

} // namespace
} // namespace espalier
