#pragma once

#include "core/radius/section_circle.h"

#include <gtest/gtest.h>

namespace espalier::test {

[[nodiscard]] inline FittedCircle circleOf(const CrossSection& section, RadiusMeasure measure) {
  const MeasuredCircle circle = measuredCircle(section, measure);
  EXPECT_TRUE(std::holds_alternative<FittedCircle>(circle));
  return std::holds_alternative<FittedCircle>(circle) ? std::get<FittedCircle>(circle)
                                                      : FittedCircle{{0, 0}, 0, 0, 0};
}

} // namespace espalier::test
