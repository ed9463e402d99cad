#pragma once

#include "app/cli/evaluate_report.h"
#include "app/cli/terminal.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/light/light_interception.h"
#include "core/evaluate/registration/registration.h"
#include "core/skeleton/skeleton.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// What `evaluate` is asked for.
struct EvaluateFlags {
  std::vector<std::string> files; // results, and the reference last
  bool noRegister = false;
  bool noRotate = false;
  UpAxis up = UpAxis::z;
  std::string shift; // X,Y,Z; empty: it is found
  std::string turn;  // X,Y,Z,DEGREES; empty: none if a shift is given, else it is found
  double scale = 1;  // of the results
  std::string unit;
  double distance = 0; // [L]; 0 = the rule
  std::string editUnit = "segment";
  std::string editCost = "topology";
  bool merges = false;
  std::string mapping; // a file; empty: none
  bool where = false;
  bool traits = false;
  bool light = false;
  int pixels = LightOptions().pixels;
  bool ranks = false;
  std::string rankBy; // empty: f
  std::size_t draws = 2000;
  std::uint64_t seed = 1;
  std::string csv;
  std::string json;
  ReportFlags report;
  int threads = 0;
};

/// Where a name that the parser has checked stands in its list.
template <class Enum> Enum named(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<Enum>(std::ranges::find(names, name) - names.begin());
}

/// How results are laid on the reference.
/// @throws WrongUsage
[[nodiscard]] RegistrationOptions registrationIn(const EvaluateFlags& flags);

/// The motion of a result that is given; none: it is to be found.
/// @throws WrongUsage
[[nodiscard]] std::optional<Eigen::Isometry3d> motionIn(const EvaluateFlags& flags,
                                                        const Skeleton& result);
/// Where the two are compared as they lie: warns how far off the result is, if that decides the
/// scores.
void warnOfPlace(Comparison& comparison, const Skeleton& result, const Skeleton& reference,
                 const EvaluateFlags& flags, const Progress& progress);

/// Compares the one result with the reference.
void evaluateOne(const EvaluateFlags& flags, const TerminalProgress& terminal);
/// Ranks the results.
void evaluateMany(const EvaluateFlags& flags, const TerminalProgress& terminal);

/// A structure that can be compared, scaled. Reports on standard error what was noted of it.
[[nodiscard]] Skeleton skeletonIn(const std::string& file, double scale = 1);
void writeTable(const std::string& file, const std::vector<std::vector<std::string>>& rows);

} // namespace espalier
