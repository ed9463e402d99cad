#include "app/cli/evaluate_text.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>

namespace espalier {
namespace {

double percent(double share) {
  return 100 * share;
}

double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

/// What hangs on what, within the distance of the landmarks.
void printConnections(const Comparison& comparison) {
  const PathLengthAgreement& ways = comparison.pathLengths;
  const ArchitectureAgreement& architecture = comparison.architecture;
  std::printf("within %.4g of each other: DIADEM-like score %.3f\n", comparison.diadem.distance,
              comparison.diadem.score);
  std::printf("  %5.1f%% of ways along the plant are as long, up to a tenth\n",
              percent(ways.withinTenth));
  if (architecture.compared > 0)
    std::printf("  %5.1f%% of the length is of the same order, %.1f%% on the same axis\n",
                percent(architecture.sameOrder), percent(architecture.sameAxis));
  else
    std::printf("  nothing lies near the reference: orders and axes cannot be compared\n");
  if (architecture.types.count() > 0)
    std::printf("  %5.1f%% of matched segments begin with the same type of edge\n",
                percent(architecture.types.observed()));
}

/// How the wood of a result compares with that of the reference: 0 where there should be none.
double excess(double result, double reference) {
  return reference > 0 ? percent(result / reference - 1) : 0;
}

} // namespace

void print(const Comparison& comparison, const std::string& unit) {
  const AuthorsComparison& authors = comparison.authors;
  std::printf("%zu of %zu segments matched with %zu of the reference\n", authors.matches.size(),
              authors.resultSegments.size(), authors.referenceSegments.size());
  std::printf("mapping %.3f  geometric index %.3f  structural index %.3f\n", authors.mapping,
              authors.geometric, authors.structural);
  std::printf("over all segments of the reference, structural index %.3f; one to many, geometric "
              "index %.3f\n",
              authors.structuralOfAll, comparison.paths.geometric);
  if (comparison.edit)
    std::printf("edit distance %.6g, similarity %.3f: %zu removed, %zu inserted\n",
                comparison.edit->distance.distance, comparison.edit->distance.similarity(),
                comparison.edit->removed, comparison.edit->inserted);
  if (comparison.registration) {
    const Eigen::Vector3d& shift = comparison.registration->shift;
    std::printf("moved by %.4g, %.4g, %.4g %s, %.4g in all, to lie on the reference\n", shift.x(),
                shift.y(), shift.z(),
                unit.empty() ? "(in the unit of the structures)" : unit.c_str(), shift.norm());
  }
  printConnections(comparison);
  std::printf("%12s %10s %10s %10s %10s %10s\n",
              (unit.empty() ? "distance" : "distance/" + unit).c_str(), "precision", "recall", "F",
              "capped G", "capped T");
  for (std::size_t k = 0; k < comparison.tolerance.scores.size(); ++k) {
    const ToleranceScore& score = comparison.tolerance.scores[k];
    std::printf("%12.4g %10.3f %10.3f %10.3f %10.3f %10.3f\n", score.distance, score.precision,
                score.recall, score.f(), comparison.capped[k].geometric,
                comparison.capped[k].structuralOfAll);
  }
}

void printWhere(const Comparison& comparison) {
  const AgreementByPlace& agreed = comparison.byPlace;
  const auto tell = [](const char* name, const PartAgreement& part) {
    const auto share = [](double value, double length) { // none of no length
      std::array<char, 16> text{'-'};
      if (length > 0) std::snprintf(text.data(), text.size(), "%.3f", value);
      return text;
    };
    std::printf(
        "%18s %10s %10s %12.6g %12.6g\n", name, share(part.precision, part.resultLength).data(),
        share(part.recall, part.referenceLength).data(), part.resultLength, part.referenceLength);
  };
  const auto head = [](const char* what) {
    std::printf("\n%18s %10s %10s %12s %12s\n", what, "precision", "recall", "result", "reference");
  };
  std::printf("\nwithin %.4g, with the lengths there are:", agreed.distance);
  head("order");
  for (const PartAgreement& part : agreed.byOrder)
    tell(std::to_string(static_cast<int>(part.from)).c_str(), part);
  head("height");
  for (const PartAgreement& part : agreed.byHeight) {
    std::array<char, 40> range{};
    std::snprintf(range.data(), range.size(), "%.4g to %.4g", part.from, part.to);
    tell(range.data(), part);
  }
  std::printf("\n%18s %12s %12s %12s\n", "radius up to", "length +%", "area +%", "volume +%");
  const std::vector<WoodAmount>& result = comparison.resultWood.byRadius;
  const std::vector<WoodAmount>& reference = comparison.referenceWood.byRadius;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    std::array<char, 40> limit{};
    if (k < comparison.radiusLimits.size())
      std::snprintf(limit.data(), limit.size(), "%.4g", comparison.radiusLimits[k]);
    std::printf("%18s %12.1f %12.1f %12.1f\n", limit[0] == 0 ? "more" : limit.data(),
                excess(result[k].length, reference[k].length),
                excess(result[k].area, reference[k].area),
                excess(result[k].volume, reference[k].volume));
  }
}

void printTraits(const Comparison& comparison) {
  const Traits& result = comparison.resultTraits;
  const Traits& reference = comparison.referenceTraits;
  std::printf("\n%21s %12s %12s %12s\n", "traits", "result", "reference", "difference");
  const auto row = [](const std::string& name, double found, double expected) {
    std::printf("%21s %12.7g %12.7g %11.1f%%\n", name.c_str(), found, expected,
                excess(found, expected));
  };
  const auto count = [](std::size_t number) { return static_cast<double>(number); };
  row("segments", count(result.segments), count(reference.segments));
  row("tips", count(result.tips), count(reference.tips));
  row("length", result.length, reference.length);
  row("orders", count(result.axesByOrder.size()), count(reference.axesByOrder.size()));
  row("Strahler number", count(result.strahler.size()), count(reference.strahler.size()));
  row("height", result.crown.height, reference.crown.height);
  row("crown base", result.crown.baseHeight, reference.crown.baseHeight);
  row("crown depth", result.crown.depth, reference.crown.depth);
  row("crown area", result.crown.area, reference.crown.area);
  row("crown diameter", result.crown.diameter, reference.crown.diameter);
  const auto& found = result.angles.byOrder;
  const auto& expected = reference.angles.byOrder;
  for (std::size_t order = 0; order < std::min(found.size(), expected.size()); ++order)
    row("angle/deg, order " + std::to_string(order + 1), degrees(found[order].mean),
        degrees(expected[order].mean));
  row("divergence/deg", degrees(result.angles.divergence.mean),
      degrees(reference.angles.divergence.mean));
}

void printLight(const Comparison& comparison) {
  std::printf("\nsilhouette to total area (STAR), overcast sky\n%21s %12s %12s\n", "pixels",
              "result", "reference");
  const auto& result = comparison.resultLight;
  const auto& reference = comparison.referenceLight;
  const auto& pixels = result ? result->convergence
                              : (reference ? reference->convergence : std::vector<StarAtPixels>());
  const auto star = [](const std::optional<LightInterception>& light, std::size_t k) {
    std::array<char, 32> text{"none"};
    if (light) std::snprintf(text.data(), text.size(), "%.5f", light->convergence[k].star);
    return std::string(text.data());
  };
  for (std::size_t k = 0; k < pixels.size(); ++k)
    std::printf("%21d %12s %12s\n", pixels[k].pixels, star(result, k).c_str(),
                star(reference, k).c_str());
}

void print(const Ranking& ranking, const std::vector<std::string>& names) {
  const auto title = [](Score score) { return scoreNames()[static_cast<std::size_t>(score)]; };
  std::printf("ranked by %s within %.4g; %.0f%% intervals of %zu draws of the segments\n",
              title(ranking.by).c_str(), ranking.distance, percent(ranking.confidence),
              ranking.draws);
  std::size_t width = 6;
  for (const std::string& name : names)
    width = std::max(width, name.size());
  std::vector<std::pair<Score, std::string>> shown = {{Score::f, "F"},
                                                      {Score::geometric, "G"},
                                                      {Score::structuralOfAll, "T of all"},
                                                      {Score::cappedGeometric, "capped G"}};
  if (std::ranges::find(shown, ranking.by, &std::pair<Score, std::string>::first) == shown.end())
    shown.insert(shown.begin(), {ranking.by, title(ranking.by)});
  const auto column = static_cast<int>(width);
  std::printf("\n%4s  %-*s", "rank", column, "result");
  for (const auto& [score, name] : shown)
    std::printf("  %-19s", name.c_str());
  std::printf("  beats the next\n");
  std::size_t rank = 0;
  for (const RankedResult& result : ranking.results) {
    std::printf("%4zu  %-*s", ++rank, column, names.at(result.result).c_str());
    for (const auto& [score, name] : shown)
      for (std::size_t k = 0; k < rankingScores().size(); ++k) {
        if (rankingScores()[k] != score) continue;
        const ScoreInterval& found = result.scores[k];
        std::printf("  %.3f (%.3f-%.3f)", found.value, found.low, found.high);
      }
    if (result.aboveNext) std::printf("  in %.1f%% of draws", percent(*result.aboveNext));
    std::printf("\n");
  }
}

} // namespace espalier
