#include "core/base/shown.h"
#include "core/evaluate/compared_plants.h"
#include "core/evaluate/score_table.h"

#include <array>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

using Plants = ComparedPlants&;
using Unit = ScoreUnit;
using Value = std::optional<double>;

template <class Member> auto ofRadii(Member member) {
  return [member](Plants plants) -> Value {
    const RadiusAgreement& radii = plants.radii();
    return radii.compared > 0 ? Value(radii.*member) : Value();
  };
}

/// Root mean square error where a quarter of the way around, from the k-th on, was seen.
Score radiusByArc(std::size_t k) {
  constexpr std::array names = {Shown::tr("RMS, 0–25 % seen"), Shown::tr("RMS, 25–50 % seen"),
                                Shown::tr("RMS, 50–75 % seen"), Shown::tr("RMS, 75–100 % seen")};
  return {.key = "radius_arc_" + std::to_string(k),
          .label = names[k],
          .help = Shown::tr(
              "Root mean square error of radii where the scan has points on this much of the "
              "circumference of the wood"),
          .measure = measureOf("Breast height, and the circumference"),
          .unit = Unit::length,
          .better = Better::less,
          .uses = inPanel, // it takes a scan in their frame
          .compute = [k](Plants plants) -> Value {
            const std::vector<RadiusByArc>& byArc = plants.radii().byArc;
            const bool isKnown = k < byArc.size() && byArc[k].compared > 0;
            return isKnown ? Value(byArc[k].rootMeanSquare) : Value();
          }};
}

} // namespace

std::vector<Score> radiusScores() {
  const Measure* stems = measureOf("Breast height, and the circumference");
  std::vector<Score> all = {
      {.key = "concordance",
       .label = Shown::tr("concordance (CCC)"),
       .symbol = Shown::tr("concordance"),
       .help = Shown::tr(
           "Agreement of radii where both lie near each other: 1 where all are the same (CCC, "
           "Lin)"),
       .measure = measureOf("Concordance"),
       .uses = inWindow | inStudies | inReport,
       .compute = ofRadii(&RadiusAgreement::concordance)},
      {.key = "radius_mean_error",
       .label = Shown::tr("mean error"),
       .symbol = Shown::tr("radius, mean error"),
       .help = Shown::tr("Of the radii: above 0, the plant's are larger"),
       .measure = measureOf("Radii"),
       .unit = Unit::length,
       .better = Better::neither,
       .uses = inWindow | inStudies | inReport,
       .compute = ofRadii(&RadiusAgreement::meanError)},
      {.key = "radius_root_mean_square",
       .label = Shown::tr("root mean square error"),
       .symbol = Shown::tr("radius, RMS error"),
       .help = Shown::tr(
           "Root mean square error of the radii, over the length where both lie near each "
           "other"),
       .measure = measureOf("Radii"),
       .unit = Unit::length,
       .better = Better::less,
       .uses = inWindow | inStudies | inReport,
       .compute = ofRadii(&RadiusAgreement::rootMeanSquare)}};
  for (std::size_t k = 0; k < 4; ++k)
    all.push_back(radiusByArc(k));
  all.push_back(
      {.key = "dbh",
       .label = Shown::tr("diameter at 1.3 m"),
       .help = Shown::tr("Of the plant's stem, 1.3 m above the foot of the reference (DBH)"),
       .measure = stems,
       .unit = Unit::length,
       .better = Better::neither,
       .uses = inWindow,
       .compute = [](Plants plants) { return plants.stems().result; }});
  all.push_back({.key = "dbh_error",
                 .label = Shown::tr("error of the diameter"),
                 .symbol = Shown::tr("diameter, error"),
                 .help = Shown::tr("The diameter of the plant at 1.3 m less that of the reference"),
                 .measure = stems,
                 .unit = Unit::length,
                 .better = Better::neither,
                 .uses = inWindow,
                 .compute = [](Plants plants) { return plants.stems().error(); }});
  return all;
}

std::vector<Score> fileScores() {
  const Measure* registration = measureOf("Registration");
  return {{.key = "shift",
           .label = Shown::tr("shift"),
           .help = Shown::tr("How far apart both were before they were aligned"),
           .measure = registration,
           .unit = Unit::length,
           .better = Better::neither,
           .uses = inMethods,
           .compute = [](Plants plants) -> Value {
             return plants.registration() ? plants.registration()->shift.norm() : 0;
           }},
          {.key = "turn",
           .label = Shown::tr("turn"),
           .symbol = Shown::tr("turn, °"),
           .help = Shown::tr("By how many degrees the plant was turned to lie on the reference"),
           .measure = registration,
           .unit = Unit::degrees,
           .better = Better::neither,
           .uses = inMethods,
           .compute = [](Plants plants) -> Value {
             if (!plants.registration()) return std::nullopt;
             return std::round(plants.registration()->angle() * 1800 / std::numbers::pi) / 10;
           }},
          {.key = "nodes",
           .label = Shown::tr("nodes"),
           .help = Shown::tr("Nodes it has"),
           .measure = measureOf("Landmarks"),
           .unit = Unit::count,
           .better = Better::neither,
           .uses = inMethods,
           .compute = [](Plants plants) -> Value {
             return static_cast<double>(plants.result().size());
           }}};
}

} // namespace espalier
