#include "tests/app/window/window_fixture.h"
#include "tests/support/fake_spacenavd.h"
#include "ui/view/plant_view.h"

#include <QGuiApplication>
#include <QTest>

namespace espalier {
namespace {

using test::WindowTest;

TEST_F(WindowTest, A3dMouseMovesThePlantAndFramesIt) {
  open({writeFork("fork.mtg")});
  test::FakeSpacenavd driver(path("spnav.sock").toStdString());
  emit qGuiApp->applicationStateChanged(Qt::ApplicationActive); // one comes back to the program
  driver.accept();
  ASSERT_TRUE(window().isActiveWindow());
  const Camera before = view().camera();
  driver.move({0, 0, 0, 0, 350, 0}, 50);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().camera() != before; }, patience));
  EXPECT_LT(view().camera().yaw, before.yaw);
  driver.move({350, 0, 0, 0, 0, 0}, 50);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().camera().focus != before.focus; }, patience));
  driver.press(0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return view().camera().focus.isApprox(before.focus, 1e-6); },
                              patience));
  driver.press(1); // nothing is selected: as the key then
  driver.press(7); // has no meaning
  QTest::qWait(50);
  EXPECT_TRUE(window().isVisible());
}

} // namespace
} // namespace espalier
