#include "ui/view/view_surface.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

struct ViewSurface : testing::Test {
  ~ViewSurface() override { qunsetenv("ESPALIER_SURFACE"); }
  ViewSurface() = default;
  ViewSurface(const ViewSurface&) = delete;
  ViewSurface& operator=(const ViewSurface&) = delete;
};

TEST_F(ViewSurface, IsAnImageWithoutWindows) {
  EXPECT_EQ(surfaceKind(), SurfaceKind::image);
}

TEST_F(ViewSurface, IsWhatTheEnvironmentSays) {
  qputenv("ESPALIER_SURFACE", "OpenGL");
  EXPECT_EQ(surfaceKind(), SurfaceKind::openGl);
  qputenv("ESPALIER_SURFACE", "image");
  EXPECT_EQ(surfaceKind(), SurfaceKind::image);
  qputenv("ESPALIER_SURFACE", "what");
  EXPECT_EQ(surfaceKind(), SurfaceKind::image) << "goes by the platform";
}

} // namespace
} // namespace espalier
