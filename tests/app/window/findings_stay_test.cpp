// How long a finding stays in the list.
#include "tests/app/window/findings_fixture.h"

namespace espalier {
namespace {

using test::FindingsWindowTest;

TEST_F(FindingsWindowTest, StayWhileTheyAreMostlyStillSo) {
  openFork();
  key(Qt::Key_F8);
  setRadiusOf(shoot(0), 0.12);
  ASSERT_TRUE(waitForTitle("1 place may be wrong"));
  setRadiusOf(shoot(0), 0.107); // within the tenth that is let pass
  EXPECT_FALSE(QTest::qWaitFor([&] { return title() == allIsWell; }, 300));
  setRadiusOf(shoot(0), 0.1);
  EXPECT_TRUE(waitForTitle(allIsWell));
  setRadiusOf(shoot(0), 0.107);
  EXPECT_FALSE(QTest::qWaitFor([&] { return title() != allIsWell; }, 300)) << "it never was more";
}

// What stands after Undo was there before, when it was no finding.
TEST_F(FindingsWindowTest, WhatAStepBroughtAboutIsGoneOnceItIsUndone) {
  openFork();
  key(Qt::Key_F8);
  setRadiusOf(shoot(0), 0.107); // within the tenth that is let pass
  ASSERT_FALSE(QTest::qWaitFor([&] { return title() != allIsWell; }, 300));
  setRadiusOf(shoot(0), 0.12);
  ASSERT_TRUE(waitForTitle("1 place may be wrong"));
  action("undo").trigger();
  EXPECT_TRUE(waitForTitle(allIsWell));
  action("redo").trigger();
  ASSERT_TRUE(waitForTitle("1 place may be wrong"));
  setRadiusOf(shoot(0), 0.107);
  setRadiusOf(nodeAt({0, 0, 0}), 0.11);
  action("undo").trigger(); // another step than that which brought it about
  EXPECT_FALSE(QTest::qWaitFor([&] { return title() == allIsWell; }, 300));
}

} // namespace
} // namespace espalier
