#include "ui/document/review_look.h"
#include "ui/view/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace espalier {
namespace {

/// What is seen of linear red, green and blue without one of the cones (G. Machado, M. Oliveira,
/// L. Fernandes, IEEE Trans. Vis. Comput. Graph. 15(6), 2009, severity 1), and with all of them.
std::vector<Eigen::Matrix3d> eyes() {
  std::vector<Eigen::Matrix3d> all(4, Eigen::Matrix3d::Identity());
  all[1] << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
      1.051998;
  all[2] << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;
  all[3] << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
      0.303900;
  return all;
}

/// CIE L*a*b* of a color to such an eye.
Eigen::Vector3d labOf(const Color& color, const Eigen::Matrix3d& eye) {
  Eigen::Vector3d linear;
  for (int c = 0; c < 3; ++c) {
    const double value = color[static_cast<std::size_t>(c)] / 255.0;
    linear[c] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  }
  Eigen::Matrix3d toXyz;
  toXyz << 0.4124 / 0.9505, 0.3576 / 0.9505, 0.1805 / 0.9505, 0.2126, 0.7152, 0.0722,
      0.0193 / 1.089, 0.1192 / 1.089, 0.9505 / 1.089;
  const Eigen::Vector3d seen = toXyz * (eye * linear).cwiseMax(0).cwiseMin(1);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  return {116 * f(seen.y()) - 16, 500 * (f(seen.x()) - f(seen.y())),
          200 * (f(seen.y()) - f(seen.z()))};
}

// A just noticeable difference is about 2.3.
TEST(Palette, DistinguishesWhatTheMethodSeesWithoutAConeToo) {
  for (const bool dark : {false, true}) {
    const Palette colors = palette(dark);
    const std::array others = {colors.reference, colors.selected, colors.contracted,
                               colors.branching, colors.text,     colors.backgroundTop};
    for (const Eigen::Matrix3d& eye : eyes())
      for (const Color& other : others)
        EXPECT_GT((labOf(colors.normal, eye) - labOf(other, eye)).norm(), 15)
            << (dark ? "dark, " : "light, ") << int(other[0]) << ' ' << int(other[1]) << ' '
            << int(other[2]);
  }
}

/// Relative luminance as WCAG 2.1 has it.
double luminanceOf(const Color& color) {
  return std::pow((labOf(color, Eigen::Matrix3d::Identity()).x() + 16) / 116, 3);
}

TEST(Palette, DistinguishesTheStatesOfAReviewFromEachOtherAndFromWhatIsSelected) {
  for (const bool dark : {false, true}) {
    const std::array shown = {colorOf(ReviewState::toDo, dark),
                              colorOf(ReviewState::doubtful, dark),
                              colorOf(ReviewState::reviewed, dark), palette(dark).selected};
    for (const Eigen::Matrix3d& eye : eyes())
      for (std::size_t i = 0; i < shown.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_GT((labOf(shown[i], eye) - labOf(shown[j], eye)).norm(), 15)
              << (dark ? "dark, " : "light, ") << i << ' ' << j;
    const double ground = luminanceOf(palette(dark).backgroundTop) + 0.05;
    for (std::size_t i = 0; i < 3; ++i) {
      const double light = luminanceOf(shown[i]) + 0.05;
      EXPECT_GT(std::max(light / ground, ground / light), 3) << dark << i; // WCAG, for graphics
    }
  }
}

} // namespace
} // namespace espalier
