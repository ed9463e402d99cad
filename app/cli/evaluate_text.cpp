#include "app/cli/evaluate_text.h"

#include "core/base/printable.h"

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

/// "10 mm", or the number alone.
std::string withUnit(double length, const std::string& unit) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.4g", length);
  return unit.empty() ? text.data() : std::string(text.data()) + " " + unit;
}

/// "height/mm"
std::string inUnit(const std::string& name, const std::string& unit,
                   const std::string& power = {}) {
  return unit.empty() ? name : name + "/" + unit + power;
}

void printNetwork(const Comparison& comparison) {
  const NetworkAgreement& network = comparison.network;
  std::printf("NetMets: %.3f of the length missed, %.3f invented; %.3f of %zu connections missed, "
              "%.3f invented; barcodes (TMD) %.3f apart\n",
              network.missedLength, network.inventedLength, network.missedConnections,
              network.connections, network.inventedConnections, comparison.barcodeDistance);
}

void printStems(const StemDiameters& stems, const std::string& unit) {
  const auto of = [&](const std::optional<double>& diameter) {
    return diameter ? withUnit(*diameter, unit) : std::string("none");
  };
  if (const auto error = stems.relativeError())
    std::printf("stem diameter at breast height (DBH) %s, of the reference %s: %+.1f%%\n",
                of(stems.result).c_str(), of(stems.reference).c_str(), percent(*error));
  else
    std::printf("stem diameter at breast height (DBH) not compared: %s%s\n", stems.missing.c_str(),
                stems.height > 0 ? "" : ", which --unit sets");
}

void printRadii(const Comparison& comparison, const std::string& unit) {
  const RadiusAgreement& radii = comparison.radii;
  if (radii.compared > 0)
    std::printf("radii: concordance (CCC) %.3f, %s off in the mean, %s in the root mean square\n",
                radii.concordance, withUnit(radii.meanError, unit).c_str(),
                withUnit(radii.rootMeanSquare, unit).c_str());
  for (const RadiusByArc& arc : radii.byArc) {
    std::printf("  %3.0f to %3.0f%% of the circumference seen: ", percent(arc.from),
                percent(arc.to));
    if (arc.compared > 0)
      std::printf("over %s, %s off in the mean, %s (%.1f%%) in the root mean square\n",
                  withUnit(arc.compared, unit).c_str(), withUnit(arc.meanError, unit).c_str(),
                  withUnit(arc.rootMeanSquare, unit).c_str(), percent(arc.relativeRootMeanSquare));
    else
      std::printf("no radii to compare\n");
  }
  printStems(comparison.stems, unit);
}

/// How far each is from the other, and what is attached to what within the distance of the
/// landmarks.
void printConnections(const Comparison& comparison, const std::string& unit) {
  const DistanceSummary& there = comparison.tolerance.toReference;
  const DistanceSummary& back = comparison.tolerance.toResult;
  std::printf("mean (Chamfer) distance to the reference %s, from it %s; 95%% (Hausdorff) within %s "
              "and %s\n",
              withUnit(there.mean, unit).c_str(), withUnit(back.mean, unit).c_str(),
              withUnit(there.percentile95, unit).c_str(),
              withUnit(back.percentile95, unit).c_str());
  const PathLengthAgreement& paths = comparison.pathLengths;
  const ArchitectureAgreement& architecture = comparison.architecture;
  std::printf("within %s of each other: tips F %.3f, branchings F %.3f, DIADEM-like score %.3f\n",
              withUnit(comparison.diadem.distance, unit).c_str(), comparison.tips.f(),
              comparison.branchings.f(), comparison.diadem.score);
  std::printf("  %5.1f%% of paths along the plant are as long, up to a tenth\n",
              percent(paths.withinTenth));
  if (architecture.compared > 0)
    std::printf("  %5.1f%% of the length is of the same order, %.1f%% on the same axis\n",
                percent(architecture.sameOrder), percent(architecture.sameAxis));
  else
    std::printf("  nothing lies near the reference: orders and axes cannot be compared\n");
  if (architecture.types.count() > 0)
    std::printf("  %5.1f%% of matched segments begin with the same type of edge\n",
                percent(architecture.types.observed()));
  printNetwork(comparison);
  printRadii(comparison, unit);
}

/// "0.912", "12.4 mm" or "17"
std::string scoreText(double value, ScoreUnit counted, const std::string& unit) {
  if (counted == ScoreUnit::length) return withUnit(value, unit);
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), counted == ScoreUnit::share ? "%.3f" : "%.6g", value);
  return text.data();
}

/// The scores that no sentence above names, a line each.
void printOthers(const Comparison& comparison, const std::string& unit) {
  for (const Score* score : leadingFirst(scoresIn(inText)))
    if (const auto& value = comparison.scores.at(score->key))
      std::printf("%s %s\n", score->label.c_str(), scoreText(*value, score->unit, unit).c_str());
}

void printByDistance(const Comparison& comparison, const std::string& unit) {
  std::printf("%12s", inUnit("distance", unit).c_str());
  for (const Score* score : scoresByDistance())
    std::printf(" %10s", score->symbol.c_str());
  std::printf("\n");
  for (const auto& [distance, values] : comparison.scoresAt) {
    std::printf("%12.4g", distance);
    for (const Score* score : scoresByDistance()) {
      const auto& value = values.at(score->key);
      std::printf(" %10s", value ? scoreText(*value, score->unit, unit).c_str() : "-");
    }
    std::printf("\n");
  }
}

/// By how many percent the result is above the reference; a dash where there should be none.
std::string excess(double result, double reference) {
  if (reference <= 0) return "-";
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.1f", percent(result / reference - 1));
  return text.data();
}

} // namespace

void print(const Comparison& comparison, const EditOptions& edit, const std::string& unit) {
  const AuthorsComparison& authors = comparison.authors;
  std::printf("%zu of %zu segments matched with %zu of the reference\n", authors.matches.size(),
              authors.resultSegments.size(), authors.referenceSegments.size());
  std::printf("mapping %.3f  geometric index %.3f  structural index %.3f\n", authors.mapping,
              authors.geometric, authors.structural);
  std::printf("over all segments of the reference, structural index %.3f; one to many, geometric "
              "index %.3f\n",
              authors.structuralOfAll, comparison.paths.geometric);
  const bool isLength = countsLength(edit.cost);
  if (comparison.edit)
    std::printf("edit distance %.6g%s, similarity %.3f: %zu removed, %zu inserted\n",
                comparison.edit->distance.distance,
                isLength && !unit.empty() ? (" " + unit).c_str() : "",
                comparison.edit->distance.similarity(), comparison.edit->removed,
                comparison.edit->inserted);
  if (comparison.registration) {
    const Eigen::Vector3d& shift = comparison.registration->shift;
    if (const double angle = comparison.registration->angle(); angle > 0) {
      const Eigen::Vector3d axis = comparison.registration->axis();
      std::printf("turned by %.4g degrees about %.3f, %.3f, %.3f, then ", degrees(angle), axis.x(),
                  axis.y(), axis.z());
    }
    std::printf("moved by %.4g, %.4g, %.4g %s, %s in all, to lie on the reference\n", shift.x(),
                shift.y(), shift.z(),
                unit.empty() ? "(in the unit of the structures)" : unit.c_str(),
                withUnit(shift.norm(), unit).c_str());
  }
  printConnections(comparison, unit);
  printOthers(comparison, unit);
  printByDistance(comparison, unit);
}

void printWhere(const Comparison& comparison, const std::string& unit) {
  const AgreementByPlace& agreed = comparison.byPlace;
  const auto printPart = [](const char* name, const PartAgreement& part) {
    const auto share = [](double value, double length) { // none of no length
      std::array<char, 16> text{'-'};
      if (length > 0) std::snprintf(text.data(), text.size(), "%.3f", value);
      return text;
    };
    std::printf(
        "%18s %10s %10s %12.6g %12.6g\n", name, share(part.precision, part.resultLength).data(),
        share(part.recall, part.referenceLength).data(), part.resultLength, part.referenceLength);
  };
  const auto head = [&](const std::string& what) {
    std::printf("\n%18s %10s %10s %12s %12s\n", what.c_str(), "precision", "recall",
                inUnit("plant", unit).c_str(), inUnit("reference", unit).c_str());
  };
  std::printf("\nwithin %s, with the lengths there are:", withUnit(agreed.distance, unit).c_str());
  head("order");
  for (const PartAgreement& part : agreed.byOrder)
    printPart(std::to_string(static_cast<int>(part.from)).c_str(), part);
  head(inUnit("height", unit));
  for (const PartAgreement& part : agreed.byHeight) {
    std::array<char, 40> range{};
    std::snprintf(range.data(), range.size(), "%.4g to %.4g", part.from, part.to);
    printPart(range.data(), part);
  }
  std::printf("\n%18s %12s %12s %12s\n", inUnit("radius up to", unit).c_str(), "length +%",
              "area +%", "volume +%");
  const std::vector<WoodAmount>& result = comparison.resultWood.byRadius;
  const std::vector<WoodAmount>& reference = comparison.referenceWood.byRadius;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    std::array<char, 40> limit{};
    if (k < comparison.radiusLimits.size())
      std::snprintf(limit.data(), limit.size(), "%.4g", comparison.radiusLimits[k]);
    std::printf("%18s %12s %12s %12s\n", limit[0] == 0 ? "more" : limit.data(),
                excess(result[k].length, reference[k].length).c_str(),
                excess(result[k].area, reference[k].area).c_str(),
                excess(result[k].volume, reference[k].volume).c_str());
  }
}

/// Means of the axes of each order, of the plant and, beside them, of the reference.
void printAxes(const std::vector<AxisTraits>& result, const std::vector<AxisTraits>& reference,
               const std::string& unit) {
  std::printf("\nmeans of axes, of the plant and of the reference\n%5s %12s %17s %17s %15s %19s\n",
              "order", "axes", inUnit("length", unit).c_str(), inUnit("chord", unit).c_str(),
              "leaves at", inUnit("base radius", unit).c_str());
  for (std::size_t order = 0; order < std::max(result.size(), reference.size()); ++order) {
    const AxisTraits found = order < result.size() ? result[order] : AxisTraits();
    const AxisTraits expected = order < reference.size() ? reference[order] : AxisTraits();
    std::printf("%5zu %5zu %6zu %8.4g %8.4g %8.4g %8.4g %7.2f %7.2f %9.3g %9.3g\n", order,
                found.count, expected.count, found.meanLength, expected.meanLength, found.meanChord,
                expected.meanChord, found.meanInsertion, expected.meanInsertion,
                found.meanBaseRadius, expected.meanBaseRadius);
  }
}

void printTraits(const Comparison& comparison, const std::string& unit) {
  const Traits& result = comparison.resultTraits;
  const Traits& reference = comparison.referenceTraits;
  std::printf("\n%21s %12s %12s %12s\n", "traits", "plant", "reference", "difference");
  const auto row = [](const std::string& name, double found, double expected) {
    const std::string above = excess(found, expected);
    std::printf("%21s %12.7g %12.7g %12s\n", name.c_str(), found, expected,
                (above == "-" ? above : above + "%").c_str());
  };
  const auto count = [](std::size_t number) { return static_cast<double>(number); };
  row("segments", count(result.segments), count(reference.segments));
  row("tips", count(result.tips), count(reference.tips));
  row(inUnit("length", unit), result.length, reference.length);
  row("orders", count(result.axesByOrder.size()), count(reference.axesByOrder.size()));
  row("Strahler number", count(result.strahler.size()), count(reference.strahler.size()));
  row(inUnit("height", unit), result.crown.height, reference.crown.height);
  row(inUnit("crown base", unit), result.crown.baseHeight, reference.crown.baseHeight);
  row(inUnit("crown depth", unit), result.crown.depth, reference.crown.depth);
  row(inUnit("crown area", unit, "^2"), result.crown.area, reference.crown.area);
  row(inUnit("crown diameter", unit), result.crown.diameter, reference.crown.diameter);
  row(inUnit("stem length", unit), result.stem.length, reference.stem.length);
  row(inUnit("lowest branch", unit), result.stem.lowestBranch, reference.stem.lowestBranch);
  row(inUnit("highest branch", unit), result.stem.highestBranch, reference.stem.highestBranch);
  row(inUnit("stem radius, base", unit), result.stem.baseRadius, reference.stem.baseRadius);
  row(inUnit("stem radius, top", unit), result.stem.topRadius, reference.stem.topRadius);
  const auto& found = result.angles.byOrder;
  const auto& expected = reference.angles.byOrder;
  for (std::size_t order = 0; order < std::min(found.size(), expected.size()); ++order)
    row("angle/deg, order " + std::to_string(order + 1), degrees(found[order].mean),
        degrees(expected[order].mean));
  row("divergence/deg", degrees(result.angles.divergence.mean),
      degrees(reference.angles.divergence.mean));
  printAxes(result.axes, reference.axes, unit);
}

void printLight(const Comparison& comparison) {
  std::printf("\nsilhouette to total area (STAR), overcast sky\n%21s %12s %12s\n", "pixels",
              "plant", "reference");
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

void print(const Ranking& ranking, const std::vector<std::string>& names, const std::string& unit) {
  std::printf("ranked by %s within %s; %.0f%% intervals of %zu draws of the segments\n",
              ranking.by.c_str(), withUnit(ranking.distance, unit).c_str(),
              percent(ranking.confidence), ranking.draws);
  std::size_t width = 9;
  for (const std::string& name : names)
    width = std::max(width, name.size());
  std::vector<std::pair<std::string, std::string>> shown; // keys and titles
  for (const Score* score : leadingFirst(scoresIn(inRankingText)))
    shown.emplace_back(score->key, score->symbol);
  if (std::ranges::find(shown, ranking.by, &std::pair<std::string, std::string>::first) ==
      shown.end())
    shown.insert(shown.begin(), {ranking.by, ranking.by}); // titled as it was asked for
  const auto column = static_cast<int>(width);
  std::printf("\n%4s  %-*s", "rank", column, "structure");
  for (const auto& [key, title] : shown)
    std::printf("  %-19s", title.c_str());
  std::printf("  beats the next\n");
  std::size_t rank = 0;
  for (const RankedResult& result : ranking.results) {
    std::printf("%4zu  %-*s", ++rank, column, printable(names.at(result.result)).c_str());
    for (const auto& [key, title] : shown) {
      const ScoreInterval& found = result.scores.at(key);
      std::printf("  %.3f (%.3f-%.3f)", found.value, found.low, found.high);
    }
    if (result.aboveNext) std::printf("  in %.1f%% of draws", percent(*result.aboveNext));
    std::printf("\n");
  }
}

} // namespace espalier
