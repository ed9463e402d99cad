#include "core/simulate/habit.h"

#include <algorithm>
#include <cassert>
#include <numbers>

namespace espalier {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double goldenAngle = 137.508 * degree;

Habit broadleaf() {
  const OrderHabit trunk{.wander = 0.2,
                         .rise = 0.5,
                         .bare = 0.22,
                         .internode = 0.024,
                         .divergence = goldenAngle,
                         .angle = 58 * degree,
                         .tipAngle = 38 * degree,
                         .ratio = 0.66,
                         .acrotony = 0.1,
                         .basitony = 0.7,
                         .shortShoots = 0.2,
                         .fork = 0.07};
  const OrderHabit bough{.wander = 0.4,
                         .rise = 0.5,
                         .bare = 0.15,
                         .internode = 0.022,
                         .divergence = goldenAngle,
                         .angle = 50 * degree,
                         .tipAngle = 40 * degree,
                         .flatness = 0.3,
                         .ratio = 0.42,
                         .acrotony = 0.4,
                         .basitony = 0.6,
                         .shortShoots = 0.4,
                         .fork = 0.12};
  const OrderHabit twig{.wander = 0.4,
                        .rise = 0.3,
                        .bare = 0.12,
                        .internode = 0.018,
                        .divergence = goldenAngle,
                        .angle = 50 * degree,
                        .tipAngle = 42 * degree,
                        .flatness = 0.4,
                        .ratio = 0.4,
                        .acrotony = 0.5,
                        .basitony = 0.6,
                        .shortShoots = 0.5,
                        .fork = 0.08};
  return {.baseRadius = 0.013, .apexRadius = 0.0006, .flare = 0.35, .orders = {trunk, bough, twig}};
}

Habit conifer() {
  const OrderHabit trunk{.wander = 0.08,
                         .rise = 0,
                         .bare = 0.1,
                         .internode = 0.06,
                         .budsPerNode = 5,
                         .divergence = 36 * degree,
                         .angle = 82 * degree,
                         .tipAngle = 50 * degree,
                         .ratio = 0.36,
                         .acrotony = 0.1,
                         .basitony = 0.75};
  const OrderHabit branch{.wander = 0.2,
                          .rise = -0.1,
                          .tipRise = 0.5,
                          .bare = 0.2,
                          .internode = 0.02,
                          .budsPerNode = 1,
                          .divergence = 180 * degree,
                          .angle = 58 * degree,
                          .tipAngle = 48 * degree,
                          .flatness = 0.85,
                          .ratio = 0.38,
                          .acrotony = 0.25,
                          .basitony = 0.8,
                          .shortShoots = 0.35};
  const OrderHabit twig{.wander = 0.25,
                        .rise = 0.15,
                        .bare = 0.2,
                        .internode = 0.016,
                        .budsPerNode = 1,
                        .divergence = 180 * degree,
                        .angle = 50 * degree,
                        .tipAngle = 45 * degree,
                        .flatness = 0.85,
                        .ratio = 0.4,
                        .acrotony = 0.25,
                        .basitony = 0.8,
                        .shortShoots = 0.4};
  return {.baseRadius = 0.011, .apexRadius = 0.0007, .flare = 0.3, .orders = {trunk, branch, twig}};
}

Habit shrub() {
  const OrderHabit stem{.wander = 0.45,
                        .rise = 0.35,
                        .bare = 0.12,
                        .internode = 0.028,
                        .divergence = goldenAngle,
                        .angle = 45 * degree,
                        .tipAngle = 40 * degree,
                        .ratio = 0.42,
                        .acrotony = 0.1,
                        .basitony = 0.7,
                        .shortShoots = 0.3,
                        .fork = 0.06};
  const OrderHabit branch{.wander = 0.5,
                          .rise = 0.45,
                          .bare = 0.12,
                          .internode = 0.025,
                          .divergence = goldenAngle,
                          .angle = 48 * degree,
                          .tipAngle = 42 * degree,
                          .ratio = 0.4,
                          .acrotony = 0.4,
                          .basitony = 0.6,
                          .shortShoots = 0.45,
                          .fork = 0.05};
  return {.stems = 7,
          .stemLean = 38 * degree,
          .baseRadius = 0.012,
          .apexRadius = 0.0009,
          .flare = 0.1,
          .orders = {stem, branch}};
}

Habit herb() {
  const OrderHabit stem{.wander = 0.22,
                        .rise = 0.1,
                        .bare = 0.1,
                        .internode = 0.07,
                        .divergence = goldenAngle,
                        .angle = 45 * degree,
                        .tipAngle = 40 * degree,
                        .ratio = 0.62,
                        .acrotony = 0.05,
                        .basitony = 0.6};
  const OrderHabit shoot{.wander = 0.3,
                         .rise = 0.7,
                         .bare = 0.2,
                         .internode = 0.06,
                         .divergence = goldenAngle,
                         .angle = 45 * degree,
                         .tipAngle = 40 * degree,
                         .ratio = 0.5,
                         .acrotony = 0.3,
                         .basitony = 0.6,
                         .shortShoots = 0.3};
  return {.baseRadius = 0.006, .apexRadius = 0.0016, .flare = 0, .orders = {stem, shoot}};
}

} // namespace

const OrderHabit& Habit::order(int order) const {
  assert(order >= 0 && !orders.empty());
  return orders[std::min(static_cast<std::size_t>(order), orders.size() - 1)];
}

Habit habitOf(Architecture architecture) {
  switch (architecture) {
  case Architecture::broadleaf:
    return broadleaf();
  case Architecture::conifer:
    return conifer();
  case Architecture::shrub:
    return shrub();
  case Architecture::herb:
    return herb();
  }
  return broadleaf();
}

} // namespace espalier
