#include "app/cli/arguments.h"
#include "app/cli/evaluate_command.h"
#include "core/base/coordinates.h"
#include "core/base/text.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/skeleton/bounds.h"

#include <charconv>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

Eigen::Vector3d shiftIn(const std::string& text) {
  if (text.empty()) return Eigen::Vector3d::Zero();
  const std::optional<Eigen::Vector3d> shift = placeIn(text);
  if (!shift) throw WrongUsage("--shift " + inQuotes(text) + ": write three numbers as X,Y,Z");
  if (shift->cwiseAbs().maxCoeff() > largestCoordinate)
    throw WrongUsage("--shift " + inQuotes(text) +
                     ": it is larger than any coordinate, which reach up to 1e12: write a smaller "
                     "one");
  return *shift;
}

Eigen::AngleAxisd turnIn(const std::string& text) {
  if (text.empty()) return Eigen::AngleAxisd::Identity();
  const std::size_t comma = text.rfind(',');
  const std::string angle = comma == std::string::npos ? text : text.substr(comma + 1);
  const std::optional<Eigen::Vector3d> axis = placeIn(text.substr(0, comma));
  double degrees = 0;
  const auto [end, error] = std::from_chars(angle.data(), angle.data() + angle.size(), degrees);
  const bool isNumber = error == std::errc() && end == angle.data() + angle.size();
  if (!axis || axis->stableNorm() == 0 || !isNumber || !(std::abs(degrees) <= 360))
    throw WrongUsage("--turn " + inQuotes(text) +
                     ": write an axis and an angle from -360 to 360 as X,Y,Z,DEGREES, such as "
                     "0,0,1,90");
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis->stableNormalized());
}

} // namespace

RegistrationOptions registrationIn(const EvaluateFlags& flags) {
  const bool isGiven = !flags.shift.empty() || !flags.turn.empty();
  if (flags.noRegister && isGiven)
    throw WrongUsage((flags.shift.empty() ? "--turn" : "--shift") +
                     std::string(" and --no-register exclude each other: give one"));
  if (flags.noRotate && !flags.turn.empty())
    throw WrongUsage("--turn and --no-rotate exclude each other: give one");
  return {.turns = !flags.noRotate, .up = flags.up};
}

std::optional<Eigen::Isometry3d> motionIn(const EvaluateFlags& flags, const Skeleton& result) {
  if (flags.shift.empty() && flags.turn.empty()) return std::nullopt;
  const Eigen::Vector3d shift = shiftIn(flags.shift);
  if (flags.turn.empty()) return Eigen::Isometry3d(Eigen::Translation3d(shift));
  const Eigen::Vector3d middle = bounds(result).center();
  return Eigen::Translation3d(middle + shift) * turnIn(flags.turn) * Eigen::Translation3d(-middle);
}

void warnOfPlace(Comparison& comparison, const Skeleton& result, const Skeleton& reference,
                 const EvaluateFlags& flags, const Progress& progress) {
  const Registration found =
      registration(result, reference, {.turns = !flags.noRotate, .up = flags.up}, progress);
  const double shift = found.shift.norm();
  if (found.angle() == 0 && shift <= defaultTolerances(reference).front()) return;
  const auto rounded = [](double value) { return plainDecimal(std::round(10 * value) / 10); };
  const std::string unit = flags.unit.empty() ? "" : " " + flags.unit;
  comparison.warnings.push_back( // on the terminal alone
      {"the plant lies about " + rounded(shift) + unit + " off the reference" +
       (found.angle() > 0
            ? ", turned by " + rounded(found.angle() * 180 / std::numbers::pi) + " degrees"
            : "") +
       ", which lowers the scores: without --no-register it is laid on it first"});
}

} // namespace espalier
