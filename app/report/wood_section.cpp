#include "app/report/report_sections.h"
#include "ui/document/shown_text.h"

#include <algorithm>

namespace espalier {
namespace {

ReportTable radiusTable(const ReportParts& parts) {
  const RadiusAgreement& radii = parts.data.comparison.radii;
  const ReportNumbers& numbers = parts.numbers;
  ReportTable table;
  table.caption = ReportText::tr("Radii where both lie within %1 of each other")
                      .arg(numbers.givenLength(radii.distance));
  table.columns = {{ReportText::tr("measure"), false}, {ReportText::tr("value")}};
  for (const Score* score : scoresIn(inReport))
    if (score->group == ScoreGroup::radii)
      table.rows.push_back(
          {{nameInUnit(*score, numbers)},
           {valueText(*score, parts.data.comparison.scores.at(score->key), numbers)}});
  table.rows.push_back(
      {{numbers.inUnit(ReportText::tr("length compared"))}, {numbers.number(radii.compared)}});
  return table;
}

/// What the errors of radii are, by how much of the circumference the scanner saw.
ReportTable arcTable(const ReportParts& parts) {
  const ReportNumbers& numbers = parts.numbers;
  ReportTable table;
  table.caption =
      ReportText::tr("Errors of radii by how much of the circumference has points of the scan");
  table.columns = {{ReportText::tr("seen"), false},
                   {numbers.inUnit(ReportText::tr("compared"))},
                   {numbers.inUnit(ReportText::tr("mean error"))},
                   {numbers.inUnit(ReportText::tr("RMS error"))},
                   {ReportText::tr("of the radius")}};
  const QString none = QStringLiteral("–");
  for (const RadiusByArc& arc : parts.data.comparison.radii.byArc) {
    const bool isKnown = arc.compared > 0;
    table.rows.push_back({{ReportText::tr("%1 to %2 %").arg(100 * arc.from).arg(100 * arc.to)},
                          {numbers.number(arc.compared)},
                          {isKnown ? numbers.number(arc.meanError) : none},
                          {isKnown ? numbers.number(arc.rootMeanSquare) : none},
                          {isKnown ? numbers.percent(arc.relativeRootMeanSquare) : none}});
  }
  return table;
}

void addStems(ReportSection& section, const ReportParts& parts) {
  const StemDiameters& stems = parts.data.comparison.stems;
  if (!stems.missing.empty()) {
    section.blocks.emplace_back(ReportParagraph{
        ReportText::tr("The diameters of the stems at breast height, 1.3 m, are not compared: %1.")
            .arg(shownText(stems.missing)),
        ReportParagraph::Look::note});
    return;
  }
  ReportTable table;
  table.caption =
      ReportText::tr("Diameter of the stem at breast height, %1 above the foot of the reference")
          .arg(parts.numbers.givenLength(stems.height));
  table.columns = {{parts.numbers.inUnit(ReportText::tr("plant"))},
                   {parts.numbers.inUnit(ReportText::tr("reference"))},
                   {ReportText::tr("difference")}};
  table.rows = {{{parts.numbers.number(*stems.result)},
                 {parts.numbers.number(*stems.reference)},
                 {parts.numbers.difference(*stems.result, *stems.reference)}}};
  section.blocks.emplace_back(std::move(table));
}

ReportTable woodTable(const ReportParts& parts, const QString& caption, const QString& what,
                      const std::vector<WoodAmount>& result,
                      const std::vector<WoodAmount>& reference, const QStringList& names) {
  const ReportNumbers& numbers = parts.numbers;
  ReportTable table;
  table.caption = caption;
  table.columns = {{what, false},
                   {numbers.inUnit(ReportText::tr("length"))},
                   {ReportText::tr("more")},
                   {numbers.inUnit(ReportText::tr("area"), 2)},
                   {ReportText::tr("more")},
                   {numbers.inUnit(ReportText::tr("volume"), 3)},
                   {ReportText::tr("more")}};
  const std::size_t count = std::max(result.size(), reference.size());
  for (std::size_t k = 0; k < count; ++k) {
    const WoodAmount found = k < result.size() ? result[k] : WoodAmount();
    const WoodAmount expected = k < reference.size() ? reference[k] : WoodAmount();
    table.rows.push_back({{names[static_cast<qsizetype>(k)]},
                          {numbers.number(found.length)},
                          {numbers.difference(found.length, expected.length)},
                          {numbers.number(found.area)},
                          {numbers.difference(found.area, expected.area)},
                          {numbers.number(found.volume)},
                          {numbers.difference(found.volume, expected.volume)}});
  }
  return table;
}

} // namespace

ReportSection woodSection(const ReportParts& parts) {
  const Comparison& comparison = parts.data.comparison;
  ReportSection section{ReportText::tr("Wood"), {}};
  section.blocks.emplace_back(ReportParagraph{ReportText::tr(
      "Of the plant, and by how much it has more than the reference. Edges count as truncated "
      "cones; those without a radius have a length alone.")});
  const std::size_t orders =
      std::max(comparison.resultWood.byOrder.size(), comparison.referenceWood.byOrder.size());
  QStringList names;
  for (std::size_t k = 0; k < orders; ++k)
    names.append(QString::number(k));
  const auto whole = [&](std::vector<WoodAmount> rows, const WoodAmount& sum) {
    rows.resize(orders);
    rows.push_back(sum);
    return rows;
  };
  names.append(ReportText::tr("all"));
  section.blocks.emplace_back(
      woodTable(parts, ReportText::tr("By order"), ReportText::tr("order"),
                whole(comparison.resultWood.byOrder, comparison.resultWood.whole),
                whole(comparison.referenceWood.byOrder, comparison.referenceWood.whole), names));
  addStems(section, parts);
  if (comparison.radii.compared > 0) section.blocks.emplace_back(radiusTable(parts));
  if (comparison.radii.compared > 0 && !comparison.radii.byArc.empty())
    section.blocks.emplace_back(arcTable(parts));
  if (comparison.radiusLimits.empty()) return section;
  names.clear();
  for (const double limit : comparison.radiusLimits)
    names.append(parts.numbers.given(limit));
  names.append(ReportText::tr("more"));
  section.blocks.emplace_back(
      woodTable(parts, ReportText::tr("By radius"), parts.numbers.inUnit(ReportText::tr("up to")),
                comparison.resultWood.byRadius, comparison.referenceWood.byRadius, names));
  return section;
}

} // namespace espalier
