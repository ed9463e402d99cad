#include "core/base/shown.h"
#include "core/evaluate/compared_plants.h"
#include "core/evaluate/score_table.h"

#include <algorithm>
#include <functional>

namespace espalier {
namespace {

using Plants = ComparedPlants&;
using Unit = ScoreUnit;
using Value = std::optional<double>;

/// A score of what both have where they lie near each other.
template <class Member> auto ofArchitecture(Member member) {
  return [member](Plants plants) -> Value {
    const ArchitectureAgreement& agreed = plants.architecture();
    return agreed.compared > 0 ? Value(agreed.*member) : Value();
  };
}

template <class Member> auto ofTypes(Member member) {
  return [member](Plants plants) -> Value {
    const TypeAgreement& types = plants.architecture().types;
    return types.count() > 0 ? Value((types.*member)()) : Value();
  };
}

Score networkScore(const char* key, const char* label, const char* symbol, const char* help,
                   double NetworkAgreement::*member) {
  return {.key = key,
          .label = label,
          .symbol = symbol,
          .help = help,
          .measure = measureOf("NetMets"),
          .better = Better::less,
          .uses = inWindow | inStudies | inReport,
          .compute = [member](Plants plants) -> Value { return plants.network().*member; }};
}

/// Of the edit distance, where it is known; in length, or in parts.
template <class Member> auto ofEdit(Member member) {
  return [member](Plants plants) -> Value {
    const std::optional<EditComparison>& edit = plants.edit();
    return edit ? Value(static_cast<double>(std::invoke(member, *edit))) : Value();
  };
}

auto editDistance(bool ofLength) {
  return [ofLength](Plants plants) -> Value {
    const std::optional<EditComparison>& edit = plants.edit();
    const bool isKnown = edit && countsLength(edit->options.cost) == ofLength;
    return isKnown ? Value(edit->distance.distance) : Value();
  };
}

} // namespace

std::vector<Score> landmarkScores() {
  const Measure* own = measureOf("Landmarks");
  return {{.key = "tips",
           .label = Shown::tr("tips, F"),
           .help = Shown::tr("Ends that lie within a median edge of each other"),
           .measure = own,
           .uses = inWindow | inStudies | inReport | inKeyNumbers,
           .compute = [](Plants plants) -> Value { return plants.tips().f(); }},
          {.key = "branchings",
           .label = Shown::tr("branchings, F"),
           .help = Shown::tr("Branchings that lie within a median edge of each other"),
           .measure = own,
           .uses = inWindow | inStudies | inReport,
           .compute = [](Plants plants) -> Value { return plants.branchings().f(); }},
          {.key = "diadem",
           .label = Shown::tr("DIADEM-like score"),
           .symbol = Shown::tr("DIADEM"),
           .help = Shown::tr(
               "Share of tips and branchings that are found and reached along a path as long"),
           .measure = measureOf("DIADEM-like score"),
           .uses = inStudies | inReport | inNoiseText,
           .compute = [](Plants plants) -> Value { return plants.diadem().score; }},
          {.key = "ways",
           .label = Shown::tr("paths along the plant as long, up to a tenth"),
           .symbol = Shown::tr("paths"),
           .help = Shown::tr(
               "Share of pairs of places whose path along the plant is as long, up to a tenth"),
           .measure = own,
           .uses = inStudies | inReport | inNoiseText,
           .compute = [](Plants plants) -> Value { return plants.pathLengths().withinTenth; }}};
}

std::vector<Score> architectureScores() {
  const Measure* own = measureOf("Orders, axes, edges");
  return {
      {.key = "order",
       .label = Shown::tr("length of the same order"),
       .symbol = Shown::tr("same order"),
       .help = Shown::tr(
           "Share of the reference's length near the plant that has the same order there"),
       .measure = own,
       .uses = inStudies | inReport,
       .compute = ofArchitecture(&ArchitectureAgreement::sameOrder)},
      {.key = "axis",
       .label = Shown::tr("length on the same axis"),
       .symbol = Shown::tr("same axis"),
       .help = Shown::tr(
           "Share of the reference's length near the plant that lies on the same axis there"),
       .measure = own,
       .uses = inStudies | inReport,
       .compute = ofArchitecture(&ArchitectureAgreement::sameAxis)},
      {.key = "edge",
       .label = Shown::tr("edge types, share that agrees"),
       .symbol = Shown::tr("same edge type"),
       .help = Shown::tr("Share of matched segments that begin with the same type of edge"),
       .measure = own,
       .uses = inStudies | inReport,
       .compute = ofTypes(&TypeAgreement::observed)},
      {.key = "edge_kappa",
       .label = Shown::tr("edge types, kappa"),
       .symbol = Shown::tr("edge types, κ"),
       .help = Shown::tr(
           "Agreement on what continues an axis and what branches, beyond chance (Cohen)"),
       .measure = measureOf("Kappa"),
       .uses = inWindow | inReport,
       .compute = ofTypes(&TypeAgreement::kappa)},
      {.key = "wrong",
       .label = Shown::tr("wrong attachments"),
       .help = Shown::tr("Parts of the plant that are attached to something else in the reference"),
       .measure = measureOf("Missed, invented, wrongly attached"),
       .unit = Unit::count,
       .better = Better::less,
       .uses = inWindow,
       .compute = [](Plants plants) -> Value {
         return static_cast<double>(std::ranges::count(
             plants.differences().parts, Difference::wronglyAttached, &DifferingPart::kind));
       }}};
}

std::vector<Score> networkScores() {
  using Network = NetworkAgreement;
  return {
      networkScore(
          "missed_length", Shown::tr("NetMets, length missed"), Shown::tr("length missed"),
          Shown::tr("Share of the reference's length that the plant lacks, by a Gaussian of the "
                    "distance (NetMets)"),
          &Network::missedLength),
      networkScore(
          "invented_length", Shown::tr("NetMets, length invented"), Shown::tr("length invented"),
          Shown::tr("Share of the plant's length that the reference lacks, by a Gaussian of the "
                    "distance (NetMets)"),
          &Network::inventedLength),
      networkScore(
          "missed_connections", Shown::tr("NetMets, connections missed"),
          Shown::tr("connections missed"),
          Shown::tr("Of the paths between tips and branchings that both have, the share of the "
                    "reference's that the plant lacks (NetMets)"),
          &Network::missedConnections),
      networkScore(
          "invented_connections", Shown::tr("NetMets, connections invented"),
          Shown::tr("connections invented"),
          Shown::tr("Of the paths between tips and branchings that both have, the share of the "
                    "plant's that the reference lacks (NetMets)"),
          &Network::inventedConnections),
      {.key = "barcode",
       .label = Shown::tr("distance of the barcodes (TMD)"),
       .symbol = Shown::tr("barcodes apart"),
       .help = Shown::tr(
           "How far the two differ in where along them their branches begin and end: 0 not "
           "at all, 1 wholly (TMD)"),
       .measure = measureOf("Barcodes (TMD)"),
       .better = Better::less,
       .uses = inWindow | inStudies | inReport,
       .compute = [](Plants plants) -> Value { return plants.barcodeDistance(); }}};
}

std::vector<Score> editScores() {
  const Measure* edit = measureOf("Edit distance");
  return {
      {.key = "edits",
       .label = Shown::tr("edit distance"),
       .help =
           Shown::tr("The least that has to be removed, inserted and changed to make one of the "
                     "other, in parts: for the costs topology and attributes"),
       .measure = edit,
       .unit = Unit::count,
       .better = Better::less,
       .uses = inWindow | inReport,
       .compute = editDistance(false)},
      {.key = "edit_length",
       .label = Shown::tr("edit distance"),
       .symbol = Shown::tr("edits, in length"),
       .help =
           Shown::tr("The least that has to be removed, inserted and changed to make one of the "
                     "other: for the costs length, place and shape"),
       .measure = edit,
       .unit = Unit::length,
       .better = Better::less,
       .uses = inWindow | inReport,
       .compute = editDistance(true)},
      {.key = "edit_similarity",
       .label = Shown::tr("edit similarity"),
       .symbol = Shown::tr("edits, similarity"),
       .help = Shown::tr("1 where nothing is to be edited, 0 where nothing of the plant is of use"),
       .measure = edit,
       .uses = inWindow | inReport,
       .compute = ofEdit([](const EditComparison& each) { return each.distance.similarity(); })},
      {.key = "edits_removed",
       .label = Shown::tr("edits: removed"),
       .symbol = Shown::tr("to remove"),
       .help = Shown::tr("Parts of the plant that stand for nothing of the reference"),
       .measure = edit,
       .unit = Unit::count,
       .better = Better::less,
       .uses = inPanel,
       .compute = ofEdit(&EditComparison::removed)},
      {.key = "edits_inserted",
       .label = Shown::tr("edits: inserted"),
       .symbol = Shown::tr("to insert"),
       .help = Shown::tr("Parts of the reference that nothing of the plant stands for"),
       .measure = edit,
       .unit = Unit::count,
       .better = Better::less,
       .uses = inPanel,
       .compute = ofEdit(&EditComparison::inserted)}};
}

} // namespace espalier
