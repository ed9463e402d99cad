#include "ui/panels/score_list.h"

#include "ui/document/number_scale.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Scores", text);
}

using Value = std::optional<double>;
constexpr auto share = ScoreKind::share;
constexpr auto length = ScoreKind::length;
constexpr auto count = ScoreKind::count;

/// What `member` tells of the comparison.
template <class Member> auto compared(Member member) {
  return [member](const Evaluation& evaluation) -> Value { return member(evaluation.comparison); };
}

std::vector<ScoreEntry> nearness() {
  const QString group = tr("Near each other");
  using C = const Comparison&;
  return {{"f", group, tr("F"), tr("F"), tr("Harmonic mean of precision and recall"), share,
           [](const Evaluation& each) -> Value { return each.score.f(); }},
          {"precision", group, tr("Precision"), tr("Precision"),
           tr("Share of the plant's length near the reference"), share,
           [](const Evaluation& each) -> Value { return each.score.precision; }},
          {"recall", group, tr("Recall"), tr("Recall"),
           tr("Share of the reference's length near the plant"), share,
           [](const Evaluation& each) -> Value { return each.score.recall; }},
          {"to_reference", group, tr("To the reference"), tr("To ref."),
           tr("Mean distance from the plant to the reference"), length,
           compared([](C c) { return c.tolerance.toReference.mean; })},
          {"from_reference", group, tr("From the reference"), tr("From ref."),
           tr("Mean distance from the reference to the plant"), length,
           compared([](C c) { return c.tolerance.toResult.mean; })},
          {"far_plant", group, tr("Far, of the plant"), tr("Far"),
           tr("Share of the plant's length that is farther from the reference than the finest "
              "tolerance"),
           share, compared([](C c) { return c.tolerance.toReference.farShare; })},
          {"substantial_to", group, tr("Substantial distance"), tr("Substantial"),
           tr("Mean distance of that length from the reference"), length,
           compared([](C c) { return c.tolerance.toReference.farMean; })},
          {"far_reference", group, tr("Far, of the reference"), tr("Ref. far"),
           tr("Share of the reference's length that is farther from the plant than the finest "
              "tolerance"),
           share, compared([](C c) { return c.tolerance.toResult.farShare; })},
          {"substantial_from", group, tr("Substantial, back"), tr("Substantial, back"),
           tr("Mean distance of that length from the plant"), length,
           compared([](C c) { return c.tolerance.toResult.farMean; })},
          {"missed_length", group, tr("Length missed"), tr("Length missed"),
           tr("Share of the reference's length that the plant lacks, by a Gaussian of the distance "
              "(NetMets)"),
           share, compared([](C c) { return c.network.missedLength; })},
          {"invented_length", group, tr("Length invented"), tr("Length invented"),
           tr("Share of the plant's length that the reference lacks, by a Gaussian of the distance "
              "(NetMets)"),
           share, compared([](C c) { return c.network.inventedLength; })}};
}

std::vector<ScoreEntry> segments() {
  const QString group = tr("Segments");
  using C = const Comparison&;
  return {{"mapping", group, tr("Mapping"), tr("Mapping"),
           tr("Share of the segments of both that are matched (authors)"), share,
           compared([](C c) { return c.authors.mapping; })},
          {"geometric", group, tr("Geometric G"), tr("G"),
           tr("Share of the length of both that is matched (authors)"), share,
           compared([](C c) { return c.authors.geometric; })},
          {"capped_geometric", group, tr("Capped G"), tr("Capped G"),
           tr("The same, matched only where they lie within the tolerance"), share,
           compared([](C c) { return c.capped.front().geometric; })},
          {"structural", group, tr("Structural T"), tr("T"),
           tr("Share of the matches whose bearers are matched, too (authors)"), share,
           compared([](C c) { return c.authors.structural; })},
          {"structural_all", group, tr("T over all segments"), tr("T, all"),
           tr("The same as a share of all segments of the reference"), share,
           compared([](C c) { return c.authors.structuralOfAll; })}};
}

std::vector<ScoreEntry> structure() {
  const QString group = tr("Attachment");
  using C = const Comparison&;
  return {
      {"tips", group, tr("Tips, F"), tr("Tips, F"),
       tr("Ends that lie within a median edge of each other"), share,
       compared([](C c) { return c.tips.f(); })},
      {"branchings", group, tr("Branchings, F"), tr("Branchings, F"),
       tr("Branchings that lie within a median edge of each other"), share,
       compared([](C c) { return c.branchings.f(); })},
      {"types", group, tr("Edge types, κ"), tr("Types, κ"),
       tr("Agreement on what continues an axis and what branches, beyond chance (Cohen)"), share,
       compared([](C c) { return c.architecture.types.kappa(); })},
      {"missed_connections", group, tr("Connections missed"), tr("Connections missed"),
       tr("Of the paths between tips and branchings that both have, the share of the reference's "
          "that the plant lacks (NetMets)"),
       share, compared([](C c) { return c.network.missedConnections; })},
      {"invented_connections", group, tr("Connections invented"), tr("Connections invented"),
       tr("Of the paths between tips and branchings that both have, the share of the plant's that "
          "the reference lacks (NetMets)"),
       share, compared([](C c) { return c.network.inventedConnections; })},
      {"barcodes", group, tr("Barcodes apart"), tr("Barcodes"),
       tr("How far the two differ in where along them their branches begin and end: 0 not at all, "
          "1 wholly (TMD)"),
       share, compared([](C c) { return c.barcodeDistance; })},
      {"wrong", group, tr("Wrong attachments"), tr("Wrong"),
       tr("Parts of the plant that are attached to something else in the reference"), count,
       [](const Evaluation& each) -> Value {
         return static_cast<double>(std::ranges::count(
             each.differences.parts, Difference::wronglyAttached, &DifferingPart::kind));
       }}};
}

std::vector<ScoreEntry> edits() {
  const QString group = tr("Edits");
  using C = const Comparison&;
  const auto distance = [](bool ofLength) {
    return compared([ofLength](C c) -> Value {
      const bool isTold = c.edit && countsLength(c.edit->options.cost) == ofLength;
      return isTold ? Value(c.edit->distance.distance) : Value();
    });
  };
  const auto parts = [](std::size_t EditComparison::*member) {
    return compared([member](C c) -> Value {
      return c.edit ? Value(static_cast<double>((*c.edit).*member)) : Value();
    });
  };
  return {{"edits", group, tr("Edit distance"), tr("Edits"),
           tr("The least that has to be removed, inserted and changed to make one of the other, in "
              "parts: for the costs topology and attributes"),
           count, distance(false)},
          {"edit_length", group, tr("In length"), tr("Edits, length"),
           tr("The least that has to be removed, inserted and changed to make one of the other: "
              "for the costs length, place and shape"),
           length, distance(true)},
          {"edit_similarity", group, tr("Similarity"), tr("Edits, similarity"),
           tr("1 where nothing is to be edited, 0 where nothing of the plant is of use"), share,
           compared([](C c) -> Value {
             return c.edit ? Value(c.edit->distance.similarity()) : Value();
           })},
          {"edits_removed",
           group,
           tr("To remove"),
           {},
           tr("Of the plant: they stand for nothing of the reference"),
           count,
           parts(&EditComparison::removed)},
          {"edits_inserted",
           group,
           tr("To insert"),
           {},
           tr("Of the reference: nothing of the plant stands for them"),
           count,
           parts(&EditComparison::inserted)}};
}

/// Root mean square error where a quarter of the way around, from the k-th on, was seen.
ScoreEntry radiusByArc(const QString& group, std::size_t k) {
  const QString name = tr("RMS, %1–%2 % seen").arg(25 * k).arg(25 * (k + 1));
  return {"radius_arc_" + std::to_string(k),
          group,
          name,
          {}, // it takes a scan in their frame
          tr("Root mean square error of radii where the scan has points on this much of the "
             "circumference "
             "around the wood"),
          length,
          compared([k](const Comparison& c) -> Value {
            const bool isKnown = k < c.radii.byArc.size() && c.radii.byArc[k].compared > 0;
            return isKnown ? Value(c.radii.byArc[k].rootMeanSquare) : Value();
          })};
}

std::vector<ScoreEntry> radii() {
  const QString group = tr("Radii");
  using C = const Comparison&;
  const auto of = [](double RadiusAgreement::*member) {
    return compared(
        [member](C c) { return c.radii.compared > 0 ? Value(c.radii.*member) : Value(); });
  };
  std::vector<ScoreEntry> entries = {
      {"concordance", group, tr("Concordance"), tr("Concordance"),
       tr("Agreement of radii where both lie near each other: 1 where all are the same (CCC, Lin)"),
       share, of(&RadiusAgreement::concordance)},
      {"radius_mean", group, tr("Mean error"), tr("Radius, mean error"),
       tr("Of the radii: above 0, the plant's are larger"), length,
       of(&RadiusAgreement::meanError)},
      {"radius_rms", group, tr("RMS error"), tr("Radius, RMS error"),
       tr("Root mean square error of the radii, over the length where both lie near each other"),
       length, of(&RadiusAgreement::rootMeanSquare)}};
  for (std::size_t k = 0; k < 4; ++k)
    entries.push_back(radiusByArc(group, k));
  entries.push_back({"dbh", group, tr("Diameter at 1.3 m"), tr("DBH"),
                     tr("Of the plant's stem, 1.3 m above the foot of the reference (DBH)"), length,
                     compared([](C c) { return c.stems.result; })});
  entries.push_back({"dbh_error", group, tr("Its error"), tr("DBH, error"),
                     tr("The diameter of the plant at 1.3 m less that of the reference"), length,
                     compared([](C c) { return c.stems.error(); })});
  return entries;
}

/// Of tables alone.
std::vector<ScoreEntry> others() {
  return {
      {"shift",
       {},
       tr("Shift"),
       tr("Shift"),
       tr("How far apart both were before they were aligned"),
       length,
       [](const Evaluation& each) -> Value { return each.shift.norm(); }},
      {"turn",
       {},
       tr("Turn"),
       tr("Turn, °"),
       tr("By how many degrees the plant was turned to lie on the reference"),
       count,
       [](const Evaluation& each) -> Value {
         if (!each.registration) return std::nullopt;
         return std::round(each.registration->angle() * 1800 / std::numbers::pi) / 10;
       }},
      {"nodes",
       {},
       tr("Nodes"),
       tr("Nodes"),
       tr("Nodes it has"),
       count,
       compared([](const Comparison& c) { return static_cast<double>(c.resultTraits.nodes); })}};
}

} // namespace

const std::vector<ScoreEntry>& scoreEntries() {
  static const std::vector<ScoreEntry> entries = [] {
    std::vector<ScoreEntry> all;
    for (const auto& some : {nearness(), segments(), structure(), edits(), radii(), others()})
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }();
  return entries;
}

Scores scoresOf(const Evaluation& evaluation) {
  Scores scores;
  for (const ScoreEntry& entry : scoreEntries())
    scores.push_back(entry.value(evaluation));
  return scores;
}

std::optional<double> scoreIn(const Scores& scores, std::string_view key) {
  const auto found = std::ranges::find(scoreEntries(), key, &ScoreEntry::key);
  return scores.at(static_cast<std::size_t>(found - scoreEntries().begin()));
}

QString textOf(const std::optional<double>& score, ScoreKind kind, LengthUnit unit) {
  if (!score) return QStringLiteral("–");
  if (kind == ScoreKind::share) return QString::number(*score, 'f', 3);
  if (kind == ScoreKind::length) return formatLength(*score, unit, 3);
  return numberText(*score, *score == std::round(*score) ? 0 : 2);
}

} // namespace espalier
