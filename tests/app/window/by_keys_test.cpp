// What is done by the keyboard alone.
#include "tests/app/window/window_fixture.h"

#include <QApplication>
#include <QTest>

namespace espalier {
namespace {

struct ByKeysTest : test::WindowTest {};

// Enter means something else in most fields.
TEST_F(ByKeysTest, EscapeGivesTheKeyboardBackToTheView) {
  open({writeFork("fork.mtg")});
  const auto press = [](Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
  };
  ASSERT_EQ(QApplication::focusWidget(), &view());
  press(Qt::Key_F8);
  press(Qt::Key_Tab, Qt::ShiftModifier);
  ASSERT_NE(QApplication::focusWidget(), &view());
  press(Qt::Key_Escape);
  EXPECT_EQ(QApplication::focusWidget(), &view());
}

} // namespace
} // namespace espalier
