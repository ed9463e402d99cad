#include "app/report/report_sections.h"

#include <algorithm>

namespace espalier {
namespace {

QString tr(const char* text) {
  return reportText(text);
}

ReportTable distanceTable(const ReportParts& parts) {
  const ReportNumbers& numbers = parts.numbers;
  const Comparison& comparison = parts.data.comparison;
  ReportTable table;
  table.columns = {{numbers.inUnit(tr("within")), false},
                   {tr("precision")},
                   {tr("recall")},
                   {tr("F")},
                   {tr("capped G")},
                   {tr("capped T")}};
  for (const ToleranceScore& score : comparison.tolerance.scores) {
    std::vector<ReportCell> row = {{numbers.given(score.distance)},
                                   {numbers.share(score.precision), score.precision},
                                   {numbers.share(score.recall), score.recall},
                                   {numbers.share(score.f()), score.f()}};
    const auto capped =
        std::ranges::find(comparison.capped, score.distance, &CappedScore::distance);
    if (capped == comparison.capped.end()) {
      row.resize(table.columns.size(), {QStringLiteral("–")});
    } else {
      row.push_back({numbers.share(capped->geometric), capped->geometric});
      row.push_back({numbers.share(capped->structuralOfAll), capped->structuralOfAll});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable howFar(const ReportParts& parts) {
  const ReportNumbers& numbers = parts.numbers;
  const ToleranceCurve& curve = parts.data.comparison.tolerance;
  ReportTable table;
  table.caption = tr("How far from one to the other, over the length");
  table.columns = {
      {tr("from"), false},
      {numbers.inUnit(tr("mean"))},
      {numbers.inUnit(tr("95 % within"))},
      {tr("over %1 off").arg(numbers.givenLength(defaultTolerances(parts.data.reference).front()))},
      {numbers.inUnit(tr("mean of these"))}};
  const auto row = [&](const QString& from, const DistanceSummary& summary) {
    table.rows.push_back({{from},
                          {numbers.number(summary.mean)},
                          {numbers.number(summary.percentile95)},
                          {numbers.percent(summary.farShare)},
                          {numbers.number(summary.farMean)}});
  };
  row(tr("the plant to the reference"), curve.toReference);
  row(tr("the reference to the plant"), curve.toResult);
  return table;
}

/// A score with its interval, where one is drawn for it.
class IndexTable {
public:
  explicit IndexTable(const ReportParts& parts) : parts_(parts) {
    table_.columns = {{tr("index"), false}, {tr("value")}, {tr("95 % interval"), false}};
  }
  void add(const QString& name, double value, std::optional<Score> score = {}) {
    add(name, parts_.numbers.share(value, 5), score);
  }
  void add(const QString& name, const QString& value, std::optional<Score> score = {}) {
    QString interval;
    if (score) {
      const auto place = std::ranges::find(rankingScores(), *score) - rankingScores().begin();
      interval = parts_.numbers.range(
          parts_.data.intervals.results.front().scores[static_cast<std::size_t>(place)]);
    }
    table_.rows.push_back({{name}, {value}, {interval}});
  }
  [[nodiscard]] ReportTable table(const QString& caption) const {
    ReportTable made = table_;
    made.caption = caption;
    const bool hasIntervals =
        std::ranges::any_of(made.rows, [](const auto& row) { return !row.back().text.isEmpty(); });
    if (hasIntervals) return made;
    made.columns.pop_back();
    for (auto& row : made.rows)
      row.pop_back();
    return made;
  }

private:
  const ReportParts& parts_;
  ReportTable table_;
};

ReportTable authorsTable(const ReportParts& parts) {
  const AuthorsComparison& authors = parts.data.comparison.authors;
  const ReportNumbers& numbers = parts.numbers;
  IndexTable table(parts);
  table.add(tr("mapping"), authors.mapping);
  table.add(tr("geometric index G"), authors.geometric, Score::geometric);
  table.add(tr("structural index T"), authors.structural, Score::structural);
  table.add(tr("T over all segments of the reference"), authors.structuralOfAll,
            Score::structuralOfAll);
  table.add(tr("G, one to many"), parts.data.comparison.paths.geometric);
  table.add(tr("length precision"), authors.lengthPrecision);
  table.add(tr("length recall"), authors.lengthRecall);
  table.add(tr("segments matched"), numbers.count(authors.matches.size()));
  table.add(tr("segments of the plant"), numbers.count(authors.resultSegments.size()));
  table.add(tr("segments of the reference"), numbers.count(authors.referenceSegments.size()));
  table.add(numbers.inUnit(tr("cost of the matching")), numbers.number(authors.cost, 9));
  return table.table(tr("As the authors of the method measure"));
}

ReportTable structureTable(const ReportParts& parts) {
  const Comparison& comparison = parts.data.comparison;
  const ReportNumbers& numbers = parts.numbers;
  IndexTable table(parts);
  table.add(tr("tips, F"), comparison.tips.f());
  table.add(tr("branchings, F"), comparison.branchings.f());
  table.add(tr("DIADEM-like score"), comparison.diadem.score);
  table.add(tr("paths along the plant as long, up to a tenth"), comparison.pathLengths.withinTenth);
  const NetworkAgreement& network = comparison.network;
  table.add(tr("NetMets, length missed"), network.missedLength);
  table.add(tr("NetMets, length invented"), network.inventedLength);
  table.add(tr("NetMets, connections missed"), network.missedConnections);
  table.add(tr("NetMets, connections invented"), network.inventedConnections);
  table.add(tr("distance of the barcodes (TMD)"), comparison.barcodeDistance);
  const ArchitectureAgreement& architecture = comparison.architecture;
  const auto of = [&](bool isCompared, double value) {
    return isCompared ? numbers.share(value, 5) : QStringLiteral("–");
  };
  const bool isNear = architecture.compared > 0;
  table.add(tr("length of the same order"), of(isNear, architecture.sameOrder));
  table.add(tr("length on the same axis"), of(isNear, architecture.sameAxis));
  const bool hasEdges = architecture.types.count() > 0;
  table.add(tr("edge types, share that agrees"), of(hasEdges, architecture.types.observed()));
  table.add(tr("edge types, kappa"), of(hasEdges, architecture.types.kappa()));
  if (comparison.edit) {
    const EditComparison& edit = *comparison.edit;
    table.add(tr("edit distance"), numbers.given(edit.distance.distance));
    table.add(tr("edit similarity"), edit.distance.similarity());
    table.add(
        tr("edits: removed, inserted"),
        QStringLiteral("%1, %2").arg(numbers.count(edit.removed), numbers.count(edit.inserted)));
  }
  return table.table(tr("Attachment; places count as found within %1")
                         .arg(numbers.givenLength(comparison.tips.distance)));
}

} // namespace

ReportSection toleranceSection(const ReportParts& parts) {
  ReportSection section{tr("Agreement over the tolerance"), {}};
  ReportPlot plot;
  plot.size = {380, 230};
  plot.text = tr("Precision, recall and F over the tolerance; marked at %1")
                  .arg(parts.numbers.givenLength(parts.data.tolerance));
  plot.paint = [curve = TolerancePlot{.curve = parts.data.curve,
                                      .chosen = parts.data.score,
                                      .unit = parts.about.unit}](
                   QPainter& painter, const QRectF& box, const PlotColors& colors) {
    curve.paint(painter, box, colors);
  };
  section.blocks.emplace_back(std::move(plot));
  section.blocks.emplace_back(distanceTable(parts));
  section.blocks.emplace_back(howFar(parts));
  return section;
}

ReportSection indicesSection(const ReportParts& parts) {
  return {tr("Indices"), {authorsTable(parts), structureTable(parts)}};
}

ReportSection placesSection(const ReportParts& parts) {
  const AgreementByPlace& agreed = parts.data.comparison.byPlace;
  const ReportNumbers& numbers = parts.numbers;
  const auto shareOf = [&](double share, double length) { // none of no length
    return length > 0 ? ReportCell{numbers.share(share), share} : ReportCell{QStringLiteral("–")};
  };
  const auto table = [&](const QString& caption, const QString& what,
                         const std::vector<PartAgreement>& rows, const auto& name) {
    ReportTable made;
    made.caption = caption;
    made.columns = {{what, false},
                    {tr("precision")},
                    {tr("recall")},
                    {numbers.inUnit(tr("plant"))},
                    {numbers.inUnit(tr("reference"))}};
    for (const PartAgreement& part : rows)
      made.rows.push_back({{name(part)},
                           shareOf(part.precision, part.resultLength),
                           shareOf(part.recall, part.referenceLength),
                           {numbers.number(part.resultLength)},
                           {numbers.number(part.referenceLength)}});
    return made;
  };
  ReportSection section{tr("Where they agree"), {}};
  section.blocks.emplace_back(ReportParagraph{
      tr("Precision and recall within %1, and the length that each plant has there. "
         "A dash: it has none.")
          .arg(numbers.givenLength(agreed.distance))});
  std::vector<PartAgreement> downward(agreed.byHeight.rbegin(), agreed.byHeight.rend());
  section.blocks.emplace_back(
      table(tr("By height, the top first"), numbers.inUnit(tr("z")), downward,
            [&](const PartAgreement& part) {
              return tr("%1 to %2").arg(numbers.number(part.from), numbers.number(part.to));
            }));
  section.blocks.emplace_back(
      table(tr("By order, the trunk first; each by its own orders"), tr("order"), agreed.byOrder,
            [](const PartAgreement& part) { return QString::number(part.from); }));
  return section;
}

} // namespace espalier
