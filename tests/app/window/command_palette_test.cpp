#include "ui/dialogs/command_palette.h"

#include <QAction>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QTest>
#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(CommandPalette, WantsEveryWordThatIsTyped) {
  EXPECT_GT(CommandPalette::match("Skeleton: Remove Subtree", "rem sub"), 0);
  EXPECT_GT(CommandPalette::match("Skeleton: Remove Subtree", "TREE"), 0);
  EXPECT_EQ(CommandPalette::match("Skeleton: Remove Subtree", "remove node"), 0);
  EXPECT_GT(CommandPalette::match("Skeleton: Remove Subtree", ""), 0);
  EXPECT_GT(CommandPalette::match("Evaluate: Next Error", "errors"), 0) << "in the plural, too";
  EXPECT_EQ(CommandPalette::match("Evaluate: Next Error", "nexts as"), 0);
  EXPECT_EQ(CommandPalette::match("View: Maximum", "axis"), 0) << "no plural";
  EXPECT_GT(CommandPalette::match("Preview: Color What Differs", "color what"),
            CommandPalette::match("View: Colors Span What Is Seen", "color what"));
}

TEST(CommandPalette, PrefersThePluralThatIsTyped) {
  EXPECT_GT(CommandPalette::match("Review: All Findings", "findings"),
            CommandPalette::match("Review: Next Finding", "findings"));
}

TEST(CommandPalette, PrefersBeginningsOfWords) {
  EXPECT_GT(CommandPalette::match("View: Top", "to"),
            CommandPalette::match("Edit: Customize", "to"));
}

TEST(CommandPalette, ShowsWhatCannotBeDoneNowAfterTheRestAndDoesNotRunIt) {
  QAction report("Export Report");
  QAction image("Export Image");
  report.setEnabled(false);
  int runs = 0;
  QObject::connect(&report, &QAction::triggered, [&] { ++runs; });
  QPointer<CommandPalette> palette = new CommandPalette({&report, &image}, nullptr);
  auto* typed = palette->findChild<QLineEdit*>();
  auto* list = palette->findChild<QListWidget*>();
  typed->setText("export");
  ASSERT_EQ(list->count(), 2);
  EXPECT_TRUE(list->item(0)->text().contains("Image"));
  EXPECT_FALSE(list->item(1)->flags().testFlag(Qt::ItemIsEnabled));
  typed->setText("report");
  QTest::keyClick(typed, Qt::Key_Return);
  ASSERT_TRUE(palette) << "Enter found nothing to run";
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualItemRect(list->item(0)).center());
  QTest::qWait(1);
  EXPECT_EQ(runs, 0);
  delete palette;
}

} // namespace
} // namespace espalier
