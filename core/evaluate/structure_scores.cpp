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
    const bool isTold = edit && countsLength(edit->options.cost) == ofLength;
    return isTold ? Value(edit->distance.distance) : Value();
  };
}

} // namespace

std::vector<Score> landmarkScores() {
  const Measure* own = measureOf("Landmarks");
  return {{.key = "tips",
           .label = "tips, F",
           .help = "Ends that lie within a median edge of each other",
           .measure = own,
           .uses = inWindow | inStudies | inReport | inKeyNumbers,
           .compute = [](Plants plants) -> Value { return plants.tips().f(); }},
          {.key = "branchings",
           .label = "branchings, F",
           .help = "Branchings that lie within a median edge of each other",
           .measure = own,
           .uses = inWindow | inStudies | inReport,
           .compute = [](Plants plants) -> Value { return plants.branchings().f(); }},
          {.key = "diadem",
           .label = "DIADEM-like score",
           .symbol = "DIADEM",
           .help = "Share of tips and branchings that are found and reached along a path as long",
           .measure = measureOf("DIADEM-like score"),
           .uses = inStudies | inReport | inNoiseText,
           .compute = [](Plants plants) -> Value { return plants.diadem().score; }},
          {.key = "ways",
           .label = "paths along the plant as long, up to a tenth",
           .symbol = "paths",
           .help = "Share of pairs of places whose path along the plant is as long, up to a tenth",
           .measure = own,
           .uses = inStudies | inReport | inNoiseText,
           .compute = [](Plants plants) -> Value { return plants.pathLengths().withinTenth; }}};
}

std::vector<Score> architectureScores() {
  const Measure* own = measureOf("Orders, axes, edges");
  return {
      {.key = "order",
       .label = "length of the same order",
       .symbol = "same order",
       .help = "Share of the reference's length near the plant that has the same order there",
       .measure = own,
       .uses = inStudies | inReport,
       .compute = ofArchitecture(&ArchitectureAgreement::sameOrder)},
      {.key = "axis",
       .label = "length on the same axis",
       .symbol = "same axis",
       .help = "Share of the reference's length near the plant that lies on the same axis there",
       .measure = own,
       .uses = inStudies | inReport,
       .compute = ofArchitecture(&ArchitectureAgreement::sameAxis)},
      {.key = "edge",
       .label = "edge types, share that agrees",
       .symbol = "same edge type",
       .help = "Share of matched segments that begin with the same type of edge",
       .measure = own,
       .uses = inStudies | inReport,
       .compute = ofTypes(&TypeAgreement::observed)},
      {.key = "edge_kappa",
       .label = "edge types, kappa",
       .symbol = "edge types, κ",
       .help = "Agreement on what continues an axis and what branches, beyond chance (Cohen)",
       .measure = measureOf("Kappa"),
       .uses = inWindow | inReport,
       .compute = ofTypes(&TypeAgreement::kappa)},
      {.key = "wrong",
       .label = "wrong attachments",
       .help = "Parts of the plant that are attached to something else in the reference",
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
  return {networkScore("missed_length", "NetMets, length missed", "length missed",
                       "Share of the reference's length that the plant lacks, by a Gaussian of the "
                       "distance (NetMets)",
                       &Network::missedLength),
          networkScore("invented_length", "NetMets, length invented", "length invented",
                       "Share of the plant's length that the reference lacks, by a Gaussian of the "
                       "distance (NetMets)",
                       &Network::inventedLength),
          networkScore("missed_connections", "NetMets, connections missed", "connections missed",
                       "Of the paths between tips and branchings that both have, the share of the "
                       "reference's that the plant lacks (NetMets)",
                       &Network::missedConnections),
          networkScore("invented_connections", "NetMets, connections invented",
                       "connections invented",
                       "Of the paths between tips and branchings that both have, the share of the "
                       "plant's that the reference lacks (NetMets)",
                       &Network::inventedConnections),
          {.key = "barcode",
           .label = "distance of the barcodes (TMD)",
           .symbol = "barcodes apart",
           .help = "How far the two differ in where along them their branches begin and end: 0 not "
                   "at all, 1 wholly (TMD)",
           .measure = measureOf("Barcodes (TMD)"),
           .better = Better::less,
           .uses = inWindow | inStudies | inReport,
           .compute = [](Plants plants) -> Value { return plants.barcodeDistance(); }}};
}

std::vector<Score> editScores() {
  const Measure* edit = measureOf("Edit distance");
  return {
      {.key = "edits",
       .label = "edit distance",
       .help = "The least that has to be removed, inserted and changed to make one of the "
               "other, in parts: for the costs topology and attributes",
       .measure = edit,
       .unit = Unit::count,
       .better = Better::less,
       .uses = inWindow | inReport,
       .compute = editDistance(false)},
      {.key = "edit_length",
       .label = "edit distance",
       .symbol = "edits, in length",
       .help = "The least that has to be removed, inserted and changed to make one of the "
               "other: for the costs length, place and shape",
       .measure = edit,
       .unit = Unit::length,
       .better = Better::less,
       .uses = inWindow | inReport,
       .compute = editDistance(true)},
      {.key = "edit_similarity",
       .label = "edit similarity",
       .symbol = "edits, similarity",
       .help = "1 where nothing is to be edited, 0 where nothing of the plant is of use",
       .measure = edit,
       .uses = inWindow | inReport,
       .compute = ofEdit([](const EditComparison& each) { return each.distance.similarity(); })},
      {.key = "edits_removed",
       .label = "edits: removed",
       .symbol = "to remove",
       .help = "Parts of the plant that stand for nothing of the reference",
       .measure = edit,
       .unit = Unit::count,
       .better = Better::less,
       .uses = inPanel,
       .compute = ofEdit(&EditComparison::removed)},
      {.key = "edits_inserted",
       .label = "edits: inserted",
       .symbol = "to insert",
       .help = "Parts of the reference that nothing of the plant stands for",
       .measure = edit,
       .unit = Unit::count,
       .better = Better::less,
       .uses = inPanel,
       .compute = ofEdit(&EditComparison::inserted)}};
}

} // namespace espalier
