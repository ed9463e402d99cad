#include "app/window/view/view_text.h"
#include "core/base/error.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

ViewText withSavedViews() {
  SavedView saved{.name = "Crown, \"from above\"",
                  .camera = {},
                  .clip = {.slab = Clip::Slab{0.25, 0.75},
                           .box = Eigen::AlignedBox3d(Eigen::Vector3d(-1, 0, 1e6),
                                                      Eigen::Vector3d(1, 0.1, 2e6))},
                  .depthFade = 0.5,
                  .hidden = {NodeId{3}, NodeId{4'000'000'000}}};
  saved.camera.pitch = 0.3;
  return {.camera = {}, .layers = {}, .choices = {}, .saved = {saved, {.name = "Plain"}}};
}

TEST(ViewText, KeepsSavedViews) {
  const ViewText view = withSavedViews();
  EXPECT_EQ(viewFrom(textOf(view)).saved, view.saved);
}

TEST(ViewText, ReadsTextsFromBeforeThereWereSavedViews) {
  EXPECT_TRUE(viewFrom(textOf(ViewText())).saved.empty());
}

TEST(ViewText, RefusesSavedViewsThatCannotBe) {
  const std::string text = textOf(withSavedViews());
  const auto with = [&](const std::string& part, const std::string& broken) {
    std::string changed = text;
    changed.replace(changed.find(part), part.size(), broken);
    return changed;
  };
  EXPECT_THROW(viewFrom(with("[0.25,0.75]", "[0.75,0.25]")), Error);
  EXPECT_THROW(viewFrom(with("[0.25,0.75]", "[0.25]")), Error);
  EXPECT_THROW(viewFrom(with("[3,4000000000]", "[\"x\"]")), Error);
}

} // namespace
} // namespace espalier
