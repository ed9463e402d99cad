#include "core/base/error.h"
#include "core/pipeline/preset.h"

#include <gtest/gtest.h>

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

TEST(Preset, HasFlagsAsTrueAndFalse) {
  PipelineOptions options;
  options.set("contract.circles=yes");
  EXPECT_EQ(options.settings["contract"]["circles"], 1);
  std::ostringstream out;
  writePreset(out, options);
  EXPECT_THAT(out.str(), testing::HasSubstr("\"circles\": true"));
  EXPECT_EQ(read(out.str()), options);
  EXPECT_EQ(read("{\"contract\": {\"circles\": \"no\"}}").settings["contract"]["circles"], 0);
  EXPECT_THROW(read("{\"contract\": {\"circles\": 1}}"), Error);
  EXPECT_THROW(read("{\"contract\": {\"radius\": true}}"), Error);
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
}

} // namespace
} // namespace espalier
