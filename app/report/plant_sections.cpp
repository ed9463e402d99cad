#include "app/report/report_sections.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/shown_text.h"

#include <algorithm>

namespace espalier {
namespace {

/// Rows of a value of the plant, one of the reference, and how much the first is above.
class BesideTable {
public:
  BesideTable(const ReportNumbers& numbers, const QString& what) : numbers_(numbers) {
    table_.columns = {{what, false},
                      {ReportText::tr("plant")},
                      {ReportText::tr("reference")},
                      {ReportText::tr("difference")}};
  }
  void add(const QString& name, double found, double expected) {
    table_.rows.push_back({{name},
                           {numbers_.number(found)},
                           {numbers_.number(expected)},
                           {numbers_.difference(found, expected)}});
  }
  void add(const QString& name, std::size_t found, std::size_t expected) {
    table_.rows.push_back(
        {{name},
         {numbers_.count(found)},
         {numbers_.count(expected)},
         {numbers_.difference(static_cast<double>(found), static_cast<double>(expected))}});
  }
  /// Of angles, which have no zero to be a share of.
  void addAngle(const QString& name, double found, double expected) {
    const double more = found - expected;
    table_.rows.push_back(
        {{name},
         {numbers_.degrees(found)},
         {numbers_.degrees(expected)},
         {(more < 0 ? QChar(0x2212) : QChar('+')) + numbers_.degrees(std::abs(more))}});
  }
  [[nodiscard]] ReportTable table(const QString& caption) && {
    table_.caption = caption;
    return std::move(table_);
  }

private:
  const ReportNumbers& numbers_;
  ReportTable table_;
};

/// The rows that both have, beside each other.
void addTraits(BesideTable& table, const ReportParts& parts) {
  const std::vector<TraitRow> expected = traitRows(parts.data.comparison.referenceTraits);
  for (const TraitRow& row : traitRows(parts.data.comparison.resultTraits)) {
    const auto same = std::ranges::find(expected, row.label, &TraitRow::label);
    if (same == expected.end()) continue;
    if (row.kind == TraitKind::angle)
      table.addAngle(nameOf(row, parts.numbers), row.value, same->value);
    else if (row.kind == TraitKind::count)
      table.add(nameOf(row, parts.numbers), static_cast<std::size_t>(row.value),
                static_cast<std::size_t>(same->value));
    else
      table.add(nameOf(row, parts.numbers), row.value, same->value);
  }
}

ReportTable axesTable(const ReportParts& parts) {
  const Traits& found = parts.data.comparison.resultTraits;
  const Traits& expected = parts.data.comparison.referenceTraits;
  BesideTable table(parts.numbers, ReportText::tr("order"));
  const std::size_t orders = std::max(found.axesByOrder.size(), expected.axesByOrder.size());
  const auto at = [](const std::vector<std::size_t>& counts, std::size_t k) {
    return k < counts.size() ? counts[k] : 0;
  };
  for (std::size_t k = 0; k < orders; ++k)
    table.add(QString::number(k), at(found.axesByOrder, k), at(expected.axesByOrder, k));
  return std::move(table).table(ReportText::tr("Axes by order"));
}

struct AxisColumn {
  QString title;
  double AxisTraits::*value;
};

/// Means over the axes of each order, those of the plant beside those of the reference.
ReportTable axisMeansTable(const ReportParts& parts, const QString& caption,
                           const std::vector<AxisColumn>& columns) {
  const std::vector<AxisTraits>& found = parts.data.comparison.resultTraits.axes;
  const std::vector<AxisTraits>& expected = parts.data.comparison.referenceTraits.axes;
  ReportTable table;
  table.caption = caption;
  table.columns = {{ReportText::tr("order"), false}};
  for (const AxisColumn& column : columns) {
    table.columns.push_back({column.title});
    table.columns.push_back({ReportText::tr("reference")});
  }
  for (std::size_t order = 0; order < std::max(found.size(), expected.size()); ++order) {
    table.rows.push_back({{QString::number(order)}});
    for (const AxisColumn& column : columns)
      for (const auto* axes : {&found, &expected})
        table.rows.back().push_back({order < axes->size()
                                         ? parts.numbers.number((*axes)[order].*column.value)
                                         : QStringLiteral("–")});
  }
  return table;
}

/// STAR of those that have radii; empty if light was not asked for.
ReportTable lightTable(const ReportParts& parts) {
  const auto& result = parts.data.comparison.resultLight;
  const auto& reference = parts.data.comparison.referenceLight;
  ReportTable table;
  if (!result && !reference) return table;
  table.caption = ReportText::tr("Silhouette to total area (STAR) under an overcast sky");
  table.columns = {
      {ReportText::tr("pixels")}, {ReportText::tr("plant")}, {ReportText::tr("reference")}};
  const auto star = [&](const std::optional<LightInterception>& light, std::size_t k) {
    return light ? parts.numbers.share(light->convergence[k].star, 5) : ReportText::tr("none");
  };
  const auto& steps = result ? result->convergence : reference->convergence;
  for (std::size_t k = 0; k < steps.size(); ++k)
    table.rows.push_back({{parts.numbers.count(static_cast<std::size_t>(steps[k].pixels))},
                          {star(result, k)},
                          {star(reference, k)}});
  return table;
}

} // namespace

QString nameOf(const TraitRow& row, const ReportNumbers& numbers) {
  QString name = numberedText(row.label);
  switch (row.kind) {
  case TraitKind::length:
    return numbers.inUnit(name);
  case TraitKind::area:
    return numbers.inUnit(name, 2);
  case TraitKind::volume:
    return numbers.inUnit(name, 3);
  default:
    return name;
  }
}

ReportSection traitsSection(const ReportParts& parts) {
  BesideTable table(parts.numbers, ReportText::tr("trait"));
  addTraits(table, parts);
  ReportSection section{ReportText::tr("Architecture"), {}};
  section.blocks.emplace_back(std::move(table).table(ReportText::tr("Each plant by itself")));
  section.blocks.emplace_back(axesTable(parts));
  const ReportNumbers& numbers = parts.numbers;
  section.blocks.emplace_back(axisMeansTable(
      parts, ReportText::tr("Means of axes: along them, straight, and where on what bears them"),
      {{numbers.inUnit(ReportText::tr("length")), &AxisTraits::meanLength},
       {numbers.inUnit(ReportText::tr("chord")), &AxisTraits::meanChord},
       {ReportText::tr("leaves at"), &AxisTraits::meanInsertion}}));
  section.blocks.emplace_back(axisMeansTable(
      parts, ReportText::tr("Mean radii of axes"),
      {{numbers.inUnit(ReportText::tr("at the base")), &AxisTraits::meanBaseRadius},
       {numbers.inUnit(ReportText::tr("at the apex")), &AxisTraits::meanTopRadius}}));
  ReportTable light = lightTable(parts);
  if (!light.rows.empty()) section.blocks.emplace_back(std::move(light));
  return section;
}

ReportSection handWorkSection(const HandWork& work, const ReportNumbers& numbers) {
  const Corrections& done = work.corrections;
  ReportTable table;
  table.columns = {{ReportText::tr("correction"), false}, {ReportText::tr("nodes")}};
  const auto add = [&](const QString& name, std::size_t count) {
    table.rows.push_back({{name}, {numbers.count(count)}});
  };
  add(ReportText::tr("added"), done.added);
  add(ReportText::tr("removed"), done.removed);
  add(ReportText::tr("moved"), done.moved);
  add(ReportText::tr("attached elsewhere"), done.reparented);
  add(ReportText::tr("another type of edge"), done.retyped);
  add(ReportText::tr("another radius"), done.radii);
  const QString edits = done.edits == 1 ? ReportText::tr("1 edit")
                                        : ReportText::tr("%1 edits").arg(numbers.count(done.edits));
  const QString text =
      done.edits == 0
          ? ReportText::tr(
                "Nothing was corrected by hand since the plant was reconstructed or opened.")
          : ReportText::tr("Since the plant was reconstructed or opened: %1, %2 of work. Pauses of "
                           "over 5 minutes do not count.")
                .arg(edits, formatWorkTime(work.time));
  ReportSection section{ReportText::tr("Work by hand"), {ReportParagraph{text}}};
  if (done.edits > 0) section.blocks.emplace_back(std::move(table));
  return section;
}

} // namespace espalier
