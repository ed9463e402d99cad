#include "ui/view/drawing_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace espalier {
namespace {

Eigen::Index goldenStep(Eigen::Index count) {
  auto step = static_cast<Eigen::Index>(std::llround(0.6180339887498949 * double(count)));
  while (step > 1 && std::gcd(step, count) != 1)
    --step;
  return std::max<Eigen::Index>(step, 1);
}

/// What `step` is to be multiplied with to give 1, but for multiples of `count`: by Euclid.
Eigen::Index inverseOf(Eigen::Index step, Eigen::Index count) {
  Eigen::Index rest = count;
  Eigen::Index next = step;
  Eigen::Index factor = 0;
  Eigen::Index nextFactor = 1;
  while (next != 0) {
    const Eigen::Index times = rest / next;
    rest = std::exchange(next, rest - times * next);
    factor = std::exchange(nextFactor, factor - times * nextFactor);
  }
  return factor < 0 ? factor + count : factor;
}

} // namespace

DrawingOrder::DrawingOrder(Eigen::Index count)
    : count_(count), step_(goldenStep(count)),
      back_(inverseOf(step_, std::max<Eigen::Index>(count, 1))) {}

} // namespace espalier
