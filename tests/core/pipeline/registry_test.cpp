#include "core/base/error.h"
#include "core/pipeline/registry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace espalier {
namespace {

/// What command lines and files take: small letters, digits and underscores.
bool isPlainName(const std::string& name) {
  return !name.empty() &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

TEST(Registry, DescribesEveryMethodAndOption) {
  for (const Step& step : pipelineSteps()) {
    EXPECT_TRUE(isPlainName(step.name)) << step.name;
    EXPECT_FALSE(step.label.empty() || step.help.empty()) << step.name;
    ASSERT_FALSE(step.methods.empty()) << step.name;
    std::set<std::string> methods;
    for (const Method& method : step.methods) {
      EXPECT_TRUE(methods.insert(method.name).second) << method.name;
      EXPECT_FALSE(method.label.empty() || method.help.empty()) << method.name;
      for (const Option& option : method.options) {
        EXPECT_TRUE(isPlainName(option.name)) << option.name;
        EXPECT_FALSE(option.label.empty() || option.help.empty()) << option.name;
        EXPECT_LT(option.minimum, option.maximum) << option.name;
      }
    }
  }
}

// So that the form can draw it, and the probe follow it.
TEST(Registry, HasBothEndsBeforeEachCurve) {
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods)
      for (std::size_t i = 0; i < method.options.size(); ++i) {
        if (method.options[i].kind != OptionKind::curve) continue;
        ASSERT_GE(i, 2U) << method.name;
        EXPECT_EQ(method.options[i - 2].kind, OptionKind::length) << method.name;
        EXPECT_EQ(method.options[i - 1].kind, OptionKind::length) << method.name;
      }
}

// What looks no farther than its reach gives the same in the preview of a part of a scan.
TEST(Registry, ReachesAsFarAsTheLongestLengthOfAContraction) {
  const PlantScale scale{.spacing = 5, .height = 4000};
  for (const Method& method : contractionStep().methods) {
    std::vector<double> values;
    double longest = 0;
    for (const Option& option : method.options) {
      values.push_back(option.rule.value(scale));
      if (option.kind == OptionKind::length) longest = std::max(longest, values.back());
    }
    EXPECT_EQ(method.probe(values).reach, longest) << method.name;
  }
}

TEST(Registry, KnowsItsStepsByWhatTheyDo) {
  EXPECT_EQ(contractionStep().name, "contract");
  EXPECT_EQ(skeletonStep().name, "skeleton");
}

TEST(Registry, HasDefaultsInTheirOwnRange) {
  const PlantScale scale{.spacing = 5, .height = 4000};
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods)
      for (const Option& option : method.options) {
        const auto [least, most] = option.range(scale);
        EXPECT_GE(option.rule.value(scale), least) << step.name << '.' << option.name;
        EXPECT_LE(option.rule.value(scale), most) << step.name << '.' << option.name;
      }
}

TEST(Registry, GivesLengthsByRulesOfThePlantNeverInAbsoluteUnits) {
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods)
      for (const Option& option : method.options)
        if (option.kind == OptionKind::length) {
          EXPECT_EQ(option.rule.fixed, 0) << option.name;
        }
}

// So that a word can be read before the method is chosen.
TEST(Registry, GivesOptionsOfOneNameInOneStepTheSameWords) {
  for (const Step& step : pipelineSteps()) {
    std::map<std::string, std::string> words;
    for (const Method& method : step.methods)
      for (const Option& option : method.options) {
        const std::string own = option.takesWords() ? option.words() : "numbers";
        EXPECT_EQ(words.try_emplace(option.name, own).first->second, own)
            << step.name << '.' << option.name;
      }
  }
}

TEST(Registry, ListsWhatThereIsWhenANameIsUnknown) {
  try {
    (void)methodNamed(stepNamed("skeleton"), "magic");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("geodesic_bins"), std::string::npos);
  }
  EXPECT_THROW((void)stepNamed("flower"), Error);
}

TEST(Rule, SaysInWordsWhatItIs) {
  EXPECT_EQ(spacings(7.5).text(), "7.5 point spacings");
  EXPECT_EQ((Rule{.fixed = 0, .spacings = 1, .heights = 0.01}.text()),
            "1 point spacing + 0.01 plant heights");
  EXPECT_EQ((spacings(1.5) + thicknesses(2.4)).text(),
            "1.5 point spacings + 2.4 thicknesses of thin wood");
  EXPECT_EQ((spacings(2) + scatters(1)).text(), "2 point spacings + 1 scatter of points");
  EXPECT_EQ(fixedAt(0).text(), "0");
}

TEST(Rule, FollowsTheThinWoodUntilItIsThickEnough) {
  const Rule rule = spacings(1.5) + thicknesses(2.4);
  const auto at = [&](double thickness) {
    return rule.value({.spacing = 2, .height = 100, .thickness = thickness});
  };
  EXPECT_DOUBLE_EQ(at(1), 3 + 2.4);
  EXPECT_DOUBLE_EQ(at(enoughThickness * 2), 15);
  EXPECT_DOUBLE_EQ(at(60), 15);
  EXPECT_DOUBLE_EQ(rule.value({.spacing = 2, .height = 100}), 15) << "not known: thick enough";
  EXPECT_FALSE(rule.isFixed());
}

TEST(Rule, FollowsTheScatterOfPoints) {
  const Rule rule = spacings(1.5) + scatters(2);
  EXPECT_DOUBLE_EQ(rule.value({.spacing = 2, .height = 100, .scatter = 3}), 3 + 6);
  EXPECT_DOUBLE_EQ(rule.value({.spacing = 2, .height = 100}), 3) << "none";
  EXPECT_FALSE(rule.isFixed());
  EXPECT_FALSE(scatters(1).isFixed());
}

} // namespace
} // namespace espalier
