#include "core/base/error.h"
#include "core/pipeline/preset.h"

#include <gtest/gtest.h>

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

TEST(Preset, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(read(""), Error);
  EXPECT_THROW(read("[1, 2]"), Error);
  EXPECT_THROW(read("{\"contract\": 5}"), Error);
  EXPECT_THROW(read("{\"flower\": {}}"), Error);
  EXPECT_THROW(read("{\"contract\": {\"method\": \"magic\"}}"), Error);
  EXPECT_THROW(read("{\"contract\": {\"radius\": \"wide\"}}"), Error);
}

} // namespace
} // namespace espalier
