#pragma once

#include "core/cloud/point_cloud.h"

namespace espalier {

/// The colors of the view; those of the skeleton are distinct to the color-blind
/// (M. Okabe, K. Ito, "Color universal design", 2008).
struct Palette {
  Color backgroundTop;
  Color backgroundBottom;
  Color text;
  Color point;      // where points have no color of their own
  Color contracted; // the accent
  Color successor;
  Color reference; // the structure that the skeleton is compared with
  Color fixedScan; // the scan of the plant, where another is laid over it
  Color movedScan; // that other
  Color branching{0xd5, 0x5e, 0x00};
  Color selected{0xe6, 0x9f, 0x00};
  Color hovered{0x56, 0xb4, 0xe9};
  Color normal{0xcc, 0x79, 0xa7}; // across a surface
  Color outline;                  // around the skeleton, so that it stands out from the points
  float relief;                   // how dark eye-dome lighting makes points, in [0, 2]
  Color solid;                    // edges and nodes drawn with their radius
};

[[nodiscard]] constexpr Palette palette(bool dark) {
  if (dark)
    return {.backgroundTop = {0x1c, 0x1f, 0x22},
            .backgroundBottom = {0x14, 0x16, 0x18},
            .text = {0xd8, 0xdc, 0xda},
            .point = {0x8d, 0x98, 0x94},
            .contracted = {0x5c, 0xc4, 0x8d},
            .successor = {0xf4, 0xf4, 0xf0},
            .reference = {0x3d, 0x9d, 0xdc},
            .fixedScan = {0x4a, 0xa3, 0xdf},
            .movedScan = {0xf0, 0xa8, 0x2c},
            .outline = {0x10, 0x12, 0x14},
            .relief = 1.4F,
            .solid = {0xc9, 0xbe, 0xae}};
  return {.backgroundTop = {0xff, 0xff, 0xff},
          .backgroundBottom = {0xec, 0xef, 0xed},
          .text = {0x3a, 0x40, 0x3d},
          .point = {0x86, 0x90, 0x8b},
          .contracted = {0x2f, 0x8f, 0x5b},
          .successor = {0x16, 0x18, 0x1a},
          .reference = {0x00, 0x72, 0xb2},
          .fixedScan = {0x00, 0x72, 0xb2},
          .movedScan = {0xd9, 0x7b, 0x00},
          .outline = {0xff, 0xff, 0xff},
          .relief = 0.8F, // dark points would swallow the dark skeleton
          .solid = {0xa8, 0x9c, 0x8a}};
}

} // namespace espalier
