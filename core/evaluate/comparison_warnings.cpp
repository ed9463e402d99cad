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
};

constexpr std::array unitPairs = {UnitPair{10, "mm", "cm"}, UnitPair{100, "cm", "m"},
                                  UnitPair{1000, "mm", "m"}};

/// The units whose ratio this is, up to what two reconstructions of a plant may differ by.
const UnitPair* unitsOf(double ratio) {
  for (const UnitPair& pair : unitPairs)
    if (std::abs(std::log(ratio / pair.ratio)) < std::log(1.5)) return &pair;
  return nullptr;
}

} // namespace

std::string warningOfTrees(const Traits& traits, std::string_view role) {
  if (traits.roots <= 1) return {};
  return std::string(role) + " is of " + std::to_string(traits.roots) +
         " separate trees, compared as one plant: keep one of them if they are not";
}

std::string warningOfTrees(const Traits& traits) {
  if (traits.roots <= 1) return {};
  return "the plant is of " + std::to_string(traits.roots) +
         " separate trees, measured as one plant: keep one of them if they are not";
}

std::string warningOfSize(const Traits& result, const Traits& reference) {
  const double quotient = result.extent.norm() / reference.extent.norm();
  const bool isLarger = quotient > 1;
  const double ratio = isLarger ? quotient : 1 / quotient;
  const UnitPair* units = unitsOf(ratio);
  if (units == nullptr && ratio <= 20) return {};
  std::ostringstream text;
  text << "the plant is "
       << plainDecimal(ratio < 100 ? std::round(10 * ratio) / 10 : std::round(ratio))
       << " times as " << (isLarger ? "large" : "small") << " as the reference: ";
  if (units == nullptr) {
    text << "check that both are in the same unit and of the same plant";
  } else {
    text << "it seems to be in " << (isLarger ? units->smaller : units->larger)
         << ", the reference in " << (isLarger ? units->larger : units->smaller)
         << "; scale the plant by " << plainDecimal(isLarger ? 1 / units->ratio : units->ratio);
  }
  return text.str();
}

std::string warningOfFit(const Registration& registration) {
  if (registration.near >= poorFit) return {};
  std::ostringstream text;
  text.precision(3);
  text << "the two fit poorly: laid on each other, "
       << plainDecimal(std::round(100 * registration.near)) << " % of their length lies within "
       << registration.nearDistance
       << " of the other, an eighth of a mean segment: check that they are of the same plant";
  return text.str();
}

std::string warningOfDistance(const ToleranceCurve& curve, bool isRegistered) {
  if (curve.scores.empty() || curve.scores.back().f() >= 0.1) return {};
  std::ostringstream text;
  text.precision(4);
  text << "hardly anything of the two lies within " << curve.scores.back().distance
       << " of the other: check that they are of the same plant"
       << (isRegistered ? "" : " and in the same frame, or let the plant be registered");
  return text.str();
}

} // namespace espalier
