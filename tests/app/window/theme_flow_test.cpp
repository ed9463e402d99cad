#include "app/window/frame/action_set.h"
#include "app/window/frame/theme_flow.h"
#include "tests/app/window/window_fixture.h"

#include <QAction>
#include <QApplication>
#include <QSignalSpy>
#include <QWindow>

namespace espalier {
namespace {

/// A window on a desktop whose theme the test decides.
struct ThemeFlowTest : testing::Test {
  QTemporaryDir folder;
  QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
  QWidget window;
  ActionSet actions{window};
  bool isSystemDark = false;
  ThemeFlow flow{{actions, settings, window, [this] { return isSystemDark; }}};

  ~ThemeFlowTest() override { applyTheme(false); }
  void changeSystem(bool isDark) {
    isSystemDark = isDark;
    window.show(); // makes the window of the desktop, which is notified
    QEvent change(QEvent::ThemeChange);
    QApplication::sendEvent(window.windowHandle(), &change);
  }
  static int lightness() { return QApplication::palette().color(QPalette::Window).lightness(); }
};

TEST_F(ThemeFlowTest, FollowsTheSystemWhileTheProgramRuns) {
  flow.start();
  EXPECT_GT(lightness(), 220);
  const QSignalSpy changes(&flow, &ThemeFlow::changed);
  changeSystem(true);
  EXPECT_LT(lightness(), 64);
  ASSERT_EQ(changes.size(), 1) << "its own palette is no change of the system";
  EXPECT_EQ(changes[0][0], true);
  changeSystem(false);
  EXPECT_GT(lightness(), 220);
}

TEST_F(ThemeFlowTest, StaysWithAThemeThatWasChosen) {
  flow.start();
  actions["theme_light"]->trigger();
  changeSystem(true);
  EXPECT_GT(lightness(), 220);
  actions["theme_system"]->trigger();
  EXPECT_LT(lightness(), 64) << "as the system is by now";
}

TEST_F(ThemeFlowTest, RemembersTheChoice) {
  actions["theme_dark"]->trigger();
  EXPECT_EQ(settings.value("theme"), "dark");
  actions["theme_light"]->setChecked(true);
  flow.start();
  EXPECT_TRUE(actions["theme_dark"]->isChecked());
}

TEST_F(ThemeFlowTest, AskingTheSystemLeavesTheLookAsItIs) {
  applyTheme(true);
  const bool first = espalier::isSystemDark();
  EXPECT_LT(lightness(), 64);
  applyTheme(false);
  EXPECT_EQ(espalier::isSystemDark(), first) << "whatever the program looks like";
}

using ThemeWindowTest = test::WindowTest;

TEST_F(ThemeWindowTest, AChangeOfTheSystemReachesTheWindow) {
  action("theme_system").trigger();
  applyTheme(true); // as nothing has: the window is to put it right
  QEvent change(QEvent::ThemeChange);
  QApplication::sendEvent(window().windowHandle(), &change);
  EXPECT_EQ(QApplication::palette().color(QPalette::Window).lightness() < 128, isSystemDark());
}

} // namespace
} // namespace espalier
