#pragma once

#include "core/cloud/point_cloud.h"

#include <vector>

namespace espalier {

// Points whose values are outside of a range. One entry per value.

struct IntensityRange {
  double least = 0; // in [0, 1]: 0 is the least intensity of the scan, 1 the greatest
  double most = 1;
};
[[nodiscard]] std::vector<bool> outsideIntensities(const std::vector<float>& intensities,
                                                   const IntensityRange& range);

struct ColorRange { // of 0 to 255 each
  int leastRed = 0, mostRed = 255;
  int leastGreen = 0, mostGreen = 255;
  int leastBlue = 0, mostBlue = 255;
};
[[nodiscard]] std::vector<bool> outsideColors(const std::vector<Color>& colors,
                                              const ColorRange& range);

struct HueRange {
  double from = 0;               // [rad], 0 is red, 120 degrees green; in [0, 2 pi]
  double to = 6.283185307179586; // less than `from`: through red
  double leastSaturation = 0;    // in [0, 1]; grays have no hue
};
/// Source: A. R. Smith, "Color gamut transform pairs", SIGGRAPH 1978 (HSV).
[[nodiscard]] std::vector<bool> outsideHues(const std::vector<Color>& colors,
                                            const HueRange& range);

struct GreennessRange {
  double least = -1; // in [-1, 2]
  double most = 2;
};
/// Excess green 2 g - r - b of the shares r + g + b = 1; black has 0.
/// Source: D. M. Woebbecke et al., "Color indices for weed identification under various soil,
/// residue, and lighting conditions", Trans. ASAE 38(1), 1995.
[[nodiscard]] std::vector<bool> outsideGreenness(const std::vector<Color>& colors,
                                                 const GreennessRange& range);

} // namespace espalier
