#include "app/window/frame/menu_letters.h"

#include <QMenu>

#include <gmock/gmock.h>

namespace espalier {
namespace {

struct MenuLettersTest : testing::Test {
  QMenu menu;

  QStringList shown(const QStringList& texts) {
    menu.clear();
    for (const QString& text : texts)
      menu.addAction(text);
    giveLetters(menu);
    return textsOf(menu);
  }
  static QStringList textsOf(QMenu& menu) {
    emit menu.aboutToShow();
    QStringList texts;
    for (const QAction* action : menu.actions())
      texts.append(action->text());
    return texts;
  }
};

TEST_F(MenuLettersTest, AnEntryKeepsTheLetterItNames) {
  EXPECT_EQ(shown({"Open", "Open &Recent"}), QStringList({"&Open", "Open &Recent"}));
}

TEST_F(MenuLettersTest, NoLetterIsGivenTwice) {
  EXPECT_EQ(shown({"Open &With", "&Worklist", "Wide"}),
            QStringList({"Open &With", "W&orklist", "W&ide"}));
}

TEST_F(MenuLettersTest, TakesTheFirstOfAWordIfItCan) {
  EXPECT_EQ(shown({"&Save", "Save As"}), QStringList({"&Save", "Save &As"}));
}

TEST_F(MenuLettersTest, LeavesAnEntryWithoutWhereAllAreTaken) {
  EXPECT_EQ(shown({"&A", "A", "…"}), QStringList({"&A", "A", "…"}));
}

TEST_F(MenuLettersTest, NumbersAreChosenByTheirDigits) {
  EXPECT_EQ(shown({"1 px", "2 px", "16 px"}), QStringList({"&1 px", "&2 px", "16 &px"}));
}

TEST_F(MenuLettersTest, OneGivesItsLetterToWhatHasNoOther) {
  EXPECT_EQ(shown({"Ab", "A"}), QStringList({"A&b", "&A"}));
  EXPECT_EQ(shown({"Ab", "Bc", "A"}), QStringList({"A&b", "B&c", "&A"}));
}

TEST_F(MenuLettersTest, AnAmpersandIsNoLetter) {
  EXPECT_EQ(shown({entryText("R&D.ply"), "Rest"}), QStringList({"&R&&D.ply", "R&est"}));
}

TEST_F(MenuLettersTest, LettersOfLinesAndHiddenEntriesAreFree) {
  QAction* hidden = menu.addAction("&Open");
  hidden->setVisible(false);
  menu.addSeparator();
  menu.addAction("O");
  giveLetters(menu);
  EXPECT_EQ(textsOf(menu).back(), "&O");
}

TEST_F(MenuLettersTest, MenusWithinHaveLettersOfTheirOwn) {
  QMenu* within = menu.addMenu("Open");
  within->addAction("Open");
  giveLetters(menu);
  EXPECT_EQ(textsOf(menu).front(), "&Open");
  EXPECT_EQ(textsOf(*within).front(), "&Open");
}

TEST_F(MenuLettersTest, AreTheSameWhenItIsShownAgain) {
  const QStringList first = shown({"&Save", "Save &S", "Sweep"});
  EXPECT_EQ(textsOf(menu), first);
}

} // namespace
} // namespace espalier
