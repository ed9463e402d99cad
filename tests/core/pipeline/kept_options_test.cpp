#include "core/base/error.h"
#include "core/pipeline/kept_options.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(KeptOptions, HaveRootAndUpBesideTheSteps) {
  PipelineOptions options;
  options.set("contract.radius=12.5");
  options.set("prune.method=none");
  EXPECT_EQ(keptOptions(keptText(options)), options);
  options.up = UpAxis::x;
  options.root = Eigen::Vector3d(500000.123456789, -1e-7, 1.0 / 3);
  EXPECT_EQ(keptOptions(keptText(options)), options) << "to the last digit";
  for (const char* text : {"up w\n{}", "root 1 2\n{}", "root 1 2 nan\n{}", "left 3\n{}", "up"})
    EXPECT_THROW(keptOptions(text), Error) << text;
}

} // namespace
} // namespace espalier
