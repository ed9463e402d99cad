#include "ui/dialogs/command_palette.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(CommandPalette, WantsEveryWordThatIsTyped) {
  EXPECT_GT(CommandPalette::match("Skeleton: Remove Subtree", "rem sub"), 0);
  EXPECT_GT(CommandPalette::match("Skeleton: Remove Subtree", "TREE"), 0);
  EXPECT_EQ(CommandPalette::match("Skeleton: Remove Subtree", "remove node"), 0);
  EXPECT_GT(CommandPalette::match("Skeleton: Remove Subtree", ""), 0);
}

TEST(CommandPalette, PrefersBeginningsOfWords) {
  EXPECT_GT(CommandPalette::match("View: Top", "to"),
            CommandPalette::match("Edit: Customize", "to"));
}

} // namespace
} // namespace espalier
