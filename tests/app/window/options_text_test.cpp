#include "app/window/preview/options_text.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

const PlantScale scale{.spacing = 2, .height = 1000};

PipelineOptions with(const std::vector<std::string>& settings) {
  PipelineOptions options;
  for (const std::string& setting : settings)
    options.set(setting);
  return options;
}

TEST(OptionsText, SaysOnlyWhatIsOtherwise) {
  EXPECT_EQ(changeText({}, {}, scale, "mm"), "");
  EXPECT_EQ(changeText({}, with({"contract.radius=12.5"}), scale, "mm"),
            QString("Contract: radius 12.5%1mm").arg(QChar(0x202f)));
  EXPECT_EQ(changeText(with({"contract.radius=12.5"}), with({"contract.radius=12.5"}), scale, "mm"),
            "");
  EXPECT_EQ(changeText(with({"contract.radius=12.5"}), {}, scale, {}), "Contract: radius 15")
      << "back to the rule, 7.5 spacings";
}

TEST(OptionsText, NamesNoValuesWhereNoScanIsOpen) {
  EXPECT_EQ(changeText({}, with({"contract.radius=12.5"}), {}, "mm"), "")
      << "there, each value is out of range";
}

TEST(OptionsText, NamesValuesThatAreOutOfRangeInThisScale) {
  EXPECT_EQ(changeText({}, with({"contract.radius=100000"}), scale, {}),
            QString("Contract: radius 100") + QChar(0x202f) + "000");
  EXPECT_EQ(
      changeText(with({"contract.radius=100000"}), with({"contract.radius=100000"}), scale, {}),
      "");
}

TEST(OptionsText, NamesTheMethodAndEachStep) {
  EXPECT_EQ(
      changeText({}, with({"contract.method=euclidean_ball", "contract.radius=8"}), scale, {}),
      "Contract: means of balls, radius 8");
  EXPECT_EQ(changeText({}, with({"contract.circles=yes", "prune.method=none"}), scale, {}),
            "Contract: fit circles yes; Prune: none");
}

TEST(OptionsText, NamesRootAndUp) {
  PipelineOptions options = with({"contract.radius=12.5"});
  options.up = UpAxis::y;
  options.root = Eigen::Vector3d(1, 2, 3);
  EXPECT_EQ(changeText({}, options, scale, {}), "Up: y; Root: picked; Contract: radius 12.5");
  EXPECT_EQ(changeText(options, {}, scale, {}), "Up: z; Root: lowest point; Contract: radius 15");
}

TEST(OptionsText, RoundsAsPeopleRead) {
  const Option length{.name = "radius", .label = "Radius", .kind = OptionKind::length};
  EXPECT_EQ(valueText(length, 38.1234, {}), "38.1");
  EXPECT_EQ(valueText(length, 0.001234, {}), "0.00123");
  EXPECT_EQ(valueText(length, 140, {}), "140");
  const Option angle{.name = "cone", .label = "Cone", .kind = OptionKind::angle};
  EXPECT_EQ(valueText(angle, 60, "mm"), "60°");
}

} // namespace
} // namespace espalier
