#include "app/report/report_data.h"

#include "core/base/error.h"
#include "core/evaluate/comparison_options.h"
#include "core/evaluate/evaluation.h"

#include <algorithm>
#include <array>
#include <utility>

namespace espalier {
namespace {

ToleranceScore scoreAt(const ToleranceCurve& curve, double tolerance) {
  const auto found = std::ranges::find(curve.scores, tolerance, &ToleranceScore::distance);
  if (found == curve.scores.end())
    throw Error("a report needs the scores at its own tolerance: compare again with it");
  return *found;
}

} // namespace

std::vector<std::size_t> shownErrors(const ReportData& data) {
  constexpr std::size_t most = 6;
  constexpr std::size_t mostOfKind = 2;
  std::array<std::size_t, 4> ofKind{};
  std::vector<std::size_t> shown;
  std::vector<std::size_t> others;
  const std::vector<DifferingPart>& parts = data.differences.parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (std::ranges::find(data.ignored, i) != data.ignored.end()) continue;
    std::size_t& count = ofKind[static_cast<std::size_t>(parts[i].kind)];
    (++count <= mostOfKind ? shown : others).push_back(i);
  }
  for (std::size_t i = 0; i < others.size() && shown.size() < most; ++i)
    shown.push_back(others[i]);
  std::ranges::sort(shown); // the parts are by length
  return shown;
}

void ignore(ReportData& data, const std::vector<DifferingPart>& ignored) {
  const auto& registration = data.comparison.registration;
  const std::vector<DifferingPart>& parts = data.differences.parts;
  data.ignored.clear();
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (std::ranges::any_of(ignored, [&](DifferingPart part) {
          if (registration) part.at = registration->motion * part.at;
          return isSame(part, parts[i], data.tolerance);
        }))
      data.ignored.push_back(i);
}

ReportData reportData(Comparison comparison, const Skeleton& result, const Skeleton& reference,
                      std::shared_ptr<const PointCloud> scan, double tolerance,
                      const Progress& progress) {
  ReportData data;
  data.comparison = std::move(comparison);
  const auto& registration = data.comparison.registration;
  data.result = registration ? moved(result, registration->motion) : result;
  data.reference = reference;
  data.scan = std::move(scan);
  data.tolerance = toleranceOr(tolerance, reference);
  data.score = scoreAt(data.comparison.tolerance, data.tolerance);
  data.differences = data.comparison.differences.tolerance == data.tolerance
                         ? std::move(data.comparison.differences)
                         : differences(data.result, reference, data.tolerance,
                                       progress.part(0, 0.3, "Finding differences"));
  data.curve = toleranceCurve(data.result, reference,
                              {.distances = curveDistances(data.tolerance,
                                                           defaultTolerances(reference).back()),
                               .step = data.comparison.tolerance.step},
                              progress.part(0.3, 0.5, "Measuring distances"))
                   .scores;
  data.intervals =
      ranking({data.result}, reference, {.registers = false, .distance = data.tolerance},
              progress.part(0.5, 0.95, "Drawing segments"));
  if (data.scan && registration)
    data.toScan =
        toScan(*data.scan, result, reference, registration->motion, progress.part(0.95, 1));
  progress.update(1);
  return data;
}

} // namespace espalier
