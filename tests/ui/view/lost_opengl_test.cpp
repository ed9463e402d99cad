// Where the context of OpenGL is lost, as by a driver that is reset, the plant comes back.
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "ui/view/plant_view.h"
#include "ui/view/view_surface.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include <cstddef>
#include <dlfcn.h>
#include <link.h>
#include <string>
#include <vector>

namespace espalier {
namespace {

/// Keeps all libraries that are loaded: the thread sanitizer ends the test where one goes whose
/// calls it passes over, as the driver does here.
void keepLibraries() {
  std::vector<std::string> names;
  const auto add = [](dl_phdr_info* library, std::size_t /*size*/, void* to) {
    static_cast<std::vector<std::string>*>(to)->emplace_back(library->dlpi_name);
    return 0;
  };
  dl_iterate_phdr(add, &names);
  for (const std::string& name : names)
    if (!name.empty()) (void)dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
}

/// All contexts of the display that stands for none go; returns whether there is such a display.
bool loseContexts() {
  const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (getDisplay == nullptr) return false;
  EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  return display != EGL_NO_DISPLAY && eglTerminate(display) == EGL_TRUE;
}

QImage drawn(PlantView& view) {
  (void)view.grab(); // a frame
  EXPECT_TRUE(QTest::qWaitFor([&] { return view.isStill(); }));
  return view.grab().toImage();
}

/// Shows all, and waits until legends have left the plant.
void settle(PlantView& view) {
  QSignalSpy settled(&view, &PlantView::settled);
  view.frameAll();
  EXPECT_TRUE(settled.wait());
}

TEST(LostOpenGl, ComesBackWithTheSamePicture) {
  if (surfaceKind() != SurfaceKind::image) GTEST_SKIP() << "Qt owns the context";
  QWidget window;
  window.resize(640, 320);
  PlantView first(&window);
  PlantView second(first, &window); // which draws in the same context
  first.setGeometry(0, 0, 320, 320);
  second.setGeometry(320, 0, 320, 320);
  std::vector<Eigen::Vector3d> places;
  const Eigen::Matrix3Xf fork = test::forkCloud();
  for (const auto& point : fork.colwise())
    places.emplace_back(point.cast<double>());
  first.setCloud(test::cloudOf(places));
  first.setSkeleton(test::fork(2));
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  for (int i = 0; i < 2; ++i) {
    settle(first);
    settle(second);
    const QImage before = drawn(first);
    const QImage beside = drawn(second);
    ASSERT_GT(test::countDifferences(before, beside.mirrored()), 100) << "there is a plant";
    keepLibraries();
    if (!loseContexts()) GTEST_SKIP() << "no EGL without a display";
    EXPECT_EQ(drawn(first), before);
    EXPECT_EQ(drawn(second), beside);
    first.setSkeleton(test::fork(3 - i)); // goes on to show what changes
    EXPECT_NE(drawn(first), before);
  }
}

} // namespace
} // namespace espalier
