#include "core/graph/turn_upright.h"

namespace espalier {

Eigen::Matrix3d turnUpright(UpAxis up) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (up == UpAxis::x) turn << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  if (up == UpAxis::y) turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return turn;
}

} // namespace espalier
