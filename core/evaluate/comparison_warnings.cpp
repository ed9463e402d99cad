#include "core/evaluate/comparison_warnings.h"

#include "core/base/text.h"

#include <array>
#include <cmath>
#include <sstream>

namespace espalier {
namespace {

struct UnitPair {
  double ratio; // of the smaller unit in the larger
  const char* smaller;
  const char* larger;
  double slack; // factor that reconstructions of one plant may differ by beside it
};

/// A tenth may well be a branch of the plant, a hundredth hardly.
constexpr std::array unitPairs = {UnitPair{10, "mm", "cm", 1.2}, UnitPair{100, "cm", "m", 1.5},
                                  UnitPair{1000, "mm", "m", 1.5}};

bool isNear(double ratio, double other, double factor) {
  return std::abs(std::log(ratio / other)) < std::log(factor);
}

/// The units in which one box is the other, up to what two reconstructions of a plant may differ
/// by: as a whole, and along each of its sides but for thin ones. A part of a plant is small, too.
const UnitPair* unitsOf(const Eigen::Vector3d& larger, const Eigen::Vector3d& smaller) {
  constexpr double thin = 0.05; // of the diagonal
  for (const UnitPair& pair : unitPairs) {
    bool fits = isNear(larger.norm() / smaller.norm(), pair.ratio, pair.slack);
    for (int side = 0; side < 3; ++side)
      if (larger[side] > thin * larger.norm() || smaller[side] > thin * smaller.norm())
        fits = fits && isNear(larger[side] / smaller[side], pair.ratio, 1.5);
    if (fits) return &pair;
  }
  return nullptr;
}

} // namespace

std::string inDigits(double value, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

std::optional<ShownMessage> warningOfTrees(const Traits& traits, ComparedAs as) {
  if (traits.roots <= 1) return std::nullopt;
  const char* text =
      as == ComparedAs::plant
          ? Shown::tr("the plant is of %1 separate trees, compared as one plant: keep one of them "
                      "if they are not")
          : Shown::tr("the reference is of %1 separate trees, compared as one plant: keep one of "
                      "them if they are not");
  return ShownMessage{text, {std::to_string(traits.roots)}};
}

std::optional<ShownMessage> warningOfTrees(const Traits& traits) {
  if (traits.roots <= 1) return std::nullopt;
  return ShownMessage{Shown::tr("the plant is of %1 separate trees, measured as one plant: keep "
                                "one of them if they are not"),
                      {std::to_string(traits.roots)}};
}

ShownMessage warningOfNoRadii(ComparedAs as) {
  return {
      as == ComparedAs::plant
          ? Shown::tr("the plant has no radii: its light is left out; estimate radii first")
          : Shown::tr("the reference has no radii: its light is left out; estimate radii first")};
}

std::optional<ShownMessage> warningOfNoRadii(const Skeleton& plant) {
  constexpr double few = 0.01; // as of tips, which end in a point in many files
  double all = 0;
  double bare = 0;
  for (const NodeId id : plant.ids()) {
    if (!plant[id].parent) continue;
    const Node& parent = plant[*plant[id].parent];
    const double length = (plant[id].position - parent.position).norm();
    all += length;
    if (plant[id].radius <= 0 && parent.radius <= 0) bare += length;
  }
  if (bare < few * all || bare == 0) return std::nullopt;
  if (bare == all)
    return ShownMessage{
        Shown::tr("the plant has no radii: its volume, areas, diameters and light are left out or "
                  "0; estimate radii first")};
  return ShownMessage{Shown::tr("%1 % of the length has no radii: volume, areas, diameters and "
                                "light lack that wood; estimate radii first"),
                      {plainDecimal(std::round(100 * bare / all))}};
}

std::optional<ShownMessage> warningOfSize(const Traits& result, const Traits& reference) {
  const double quotient = result.extent.norm() / reference.extent.norm();
  const bool isLarger = quotient > 1;
  const double ratio = isLarger ? quotient : 1 / quotient;
  const UnitPair* units = unitsOf(isLarger ? result.extent : reference.extent,
                                  isLarger ? reference.extent : result.extent);
  if (units == nullptr && ratio <= 20) return std::nullopt;
  const std::string times =
      plainDecimal(ratio < 100 ? std::round(10 * ratio) / 10 : std::round(ratio));
  if (units == nullptr)
    return ShownMessage{
        isLarger ? Shown::tr("the plant is %1 times as large as the reference: check that both are "
                             "in the same unit and of the same plant")
                 : Shown::tr("the plant is %1 times as small as the reference: check that both are "
                             "in the same unit and of the same plant"),
        {times}};
  const char* text =
      isLarger ? Shown::tr("the plant is %1 times as large as the reference: it seems to be in %2, "
                           "the reference in %3; scale the plant by %4")
               : Shown::tr("the plant is %1 times as small as the reference: it seems to be in %2, "
                           "the reference in %3; scale the plant by %4");
  return ShownMessage{text,
                      {times, isLarger ? units->smaller : units->larger,
                       isLarger ? units->larger : units->smaller,
                       plainDecimal(isLarger ? 1 / units->ratio : units->ratio)}};
}

std::optional<ShownMessage> warningOfFit(const Registration& registration) {
  if (registration.near >= poorFit) return std::nullopt;
  return ShownMessage{
      Shown::tr("the two fit poorly: laid on each other, %1 % of their length lies within %2 of "
                "the other, an eighth of a mean segment: check that they are of the same plant"),
      {plainDecimal(std::round(100 * registration.near)), inDigits(registration.nearDistance, 3)}};
}

std::optional<ShownMessage> warningOfDistance(const ToleranceCurve& curve, bool isRegistered) {
  if (curve.scores.empty() || curve.scores.back().f() >= 0.1) return std::nullopt;
  const char* text =
      isRegistered
          ? Shown::tr("hardly anything of the two lies within %1 of the other: check that they are "
                      "of the same plant")
          : Shown::tr("hardly anything of the two lies within %1 of the other: check that they are "
                      "of the same plant and in the same frame, or let the plant be registered");
  return ShownMessage{text, {inDigits(curve.scores.back().distance, 4)}};
}

} // namespace espalier
