#include "app/report/report_sections.h"

#include <algorithm>

namespace espalier {
namespace {

ReportTable distanceTable(const ReportParts& parts) {
  const ReportNumbers& numbers = parts.numbers;
  ReportTable table;
  table.columns = {{numbers.inUnit(ReportText::tr("within")), false}};
  for (const Score* score : scoresByDistance())
    table.columns.push_back({symbolOf(*score)});
  for (const auto& [distance, values] : parts.data.comparison.scoresAt) {
    std::vector<ReportCell> row = {{numbers.given(distance)}};
    for (const Score* score : scoresByDistance()) {
      const auto& value = values.at(score->key);
      row.push_back(value ? ReportCell{numbers.share(*value), *value}
                          : ReportCell{QStringLiteral("–")});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable howFar(const ReportParts& parts) {
  const ReportNumbers& numbers = parts.numbers;
  const ToleranceCurve& curve = parts.data.comparison.tolerance;
  ReportTable table;
  table.caption = ReportText::tr("How far from one to the other, over the length");
  table.columns = {{ReportText::tr("from"), false},
                   {numbers.inUnit(ReportText::tr("mean"))},
                   {numbers.inUnit(ReportText::tr("95 % within"))},
                   {ReportText::tr("over %1 off")
                        .arg(numbers.givenLength(defaultTolerances(parts.data.reference).front()))},
                   {numbers.inUnit(ReportText::tr("mean of these"))}};
  const auto row = [&](const QString& from, const DistanceSummary& summary) {
    table.rows.push_back({{from},
                          {numbers.number(summary.mean)},
                          {numbers.number(summary.percentile95)},
                          {numbers.percent(summary.farShare)},
                          {numbers.number(summary.farMean)}});
  };
  row(ReportText::tr("the plant to the reference"), curve.toReference);
  row(ReportText::tr("the reference to the plant"), curve.toResult);
  return table;
}

/// Scores and other numbers, with an interval where segments are drawn for it.
class IndexTable {
public:
  explicit IndexTable(const ReportParts& parts) : parts_(parts) {
    table_.columns = {{ReportText::tr("index"), false},
                      {ReportText::tr("value")},
                      {ReportText::tr("95 % interval"), false}};
  }
  void add(const QString& name, const QString& value, const QString& interval = {}) {
    table_.rows.push_back({{name}, {value}, {interval}});
  }
  void add(const QString& name, double share) { add(name, parts_.numbers.share(share, 5)); }
  /// The scores of a group that tables of reports show.
  void add(ScoreGroup group) {
    const auto& intervals = parts_.data.intervals.results.front().scores;
    for (const Score* score : scoresIn(inReport)) {
      if (score->group != group || score->takesDistance) continue;
      const auto& value = parts_.data.comparison.scores.at(score->key);
      if (!value && group == ScoreGroup::edits) continue; // of another cost
      const auto interval = intervals.find(score->key);
      add(nameInUnit(*score, parts_.numbers), valueText(*score, value, parts_.numbers),
          interval == intervals.end() ? QString() : parts_.numbers.range(interval->second));
    }
  }
  [[nodiscard]] bool isEmpty() const { return table_.rows.empty(); }
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
  table.add(ScoreGroup::segments);
  table.add(ReportText::tr("length precision"), authors.lengthPrecision);
  table.add(ReportText::tr("length recall"), authors.lengthRecall);
  table.add(ReportText::tr("segments matched"), numbers.count(authors.matches.size()));
  table.add(ReportText::tr("segments of the plant"), numbers.count(authors.resultSegments.size()));
  table.add(ReportText::tr("segments of the reference"),
            numbers.count(authors.referenceSegments.size()));
  table.add(numbers.inUnit(ReportText::tr("cost of the matching")),
            numbers.number(authors.cost, 9));
  return table.table(ReportText::tr("As the authors of the method measure"));
}

ReportTable structureTable(const ReportParts& parts) {
  const Comparison& comparison = parts.data.comparison;
  const ReportNumbers& numbers = parts.numbers;
  IndexTable table(parts);
  for (const ScoreGroup group :
       {ScoreGroup::landmarks, ScoreGroup::network, ScoreGroup::architecture, ScoreGroup::edits})
    table.add(group);
  if (const auto& edit = comparison.edit)
    table.add(
        ReportText::tr("edits: removed, inserted"),
        QStringLiteral("%1, %2").arg(numbers.count(edit->removed), numbers.count(edit->inserted)));
  return table.table(ReportText::tr("Attachment; places count as found within %1")
                         .arg(numbers.givenLength(comparison.tips.distance)));
}

} // namespace

QString nameInUnit(const Score& score, const ReportNumbers& numbers) {
  const QString name = labelOf(score);
  return score.unit == ScoreUnit::length ? numbers.inUnit(name) : name;
}

QString valueText(const Score& score, const std::optional<double>& value,
                  const ReportNumbers& numbers) {
  if (!value) return QStringLiteral("–");
  if (score.unit == ScoreUnit::share) return numbers.share(*value, 5);
  return score.unit == ScoreUnit::length ? numbers.number(*value) : numbers.given(*value);
}

ReportSection toleranceSection(const ReportParts& parts) {
  ReportSection section{ReportText::tr("Agreement over the tolerance"), {}};
  ReportPlot plot;
  plot.size = {380, 230};
  plot.text = ReportText::tr("Precision, recall and F over the tolerance; marked at %1")
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
  ReportSection section{ReportText::tr("Indices"), {authorsTable(parts), structureTable(parts)}};
  IndexTable others(parts);
  for (const ScoreGroup group : {ScoreGroup::nearness, ScoreGroup::capped, ScoreGroup::files})
    others.add(group);
  if (!others.isEmpty()) section.blocks.emplace_back(others.table(ReportText::tr("Others")));
  return section;
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
                    {ReportText::tr("precision")},
                    {ReportText::tr("recall")},
                    {numbers.inUnit(ReportText::tr("plant"))},
                    {numbers.inUnit(ReportText::tr("reference"))}};
    for (const PartAgreement& part : rows)
      made.rows.push_back({{name(part)},
                           shareOf(part.precision, part.resultLength),
                           shareOf(part.recall, part.referenceLength),
                           {numbers.number(part.resultLength)},
                           {numbers.number(part.referenceLength)}});
    return made;
  };
  ReportSection section{ReportText::tr("Where they agree"), {}};
  section.blocks.emplace_back(ReportParagraph{
      ReportText::tr("Precision and recall within %1, and the length that each plant has there. "
                     "A dash: it has none.")
          .arg(numbers.givenLength(agreed.distance))});
  std::vector<PartAgreement> downward(agreed.byHeight.rbegin(), agreed.byHeight.rend());
  section.blocks.emplace_back(table(
      ReportText::tr("By height, the top first"), numbers.inUnit(ReportText::tr("z")), downward,
      [&](const PartAgreement& part) {
        return ReportText::tr("%1 to %2").arg(numbers.number(part.from), numbers.number(part.to));
      }));
  section.blocks.emplace_back(table(
      ReportText::tr("By order, the trunk first; each by its own orders"), ReportText::tr("order"),
      agreed.byOrder, [](const PartAgreement& part) { return QString::number(part.from); }));
  return section;
}

} // namespace espalier
