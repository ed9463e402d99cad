#include "app/report/report_sections.h"
#include "ui/document/difference_look.h"
#include "ui/document/shown_message.h"
#include "ui/view/point_colors.h"

#include <algorithm>

namespace espalier {
namespace {

struct Counts {
  std::size_t missed = 0;
  std::size_t invented = 0;
  std::size_t wronglyAttached = 0;
};

Counts countsOf(const Differences& differences) {
  Counts counts;
  for (const DifferingPart& part : differences.parts)
    ++(part.kind == Difference::missed     ? counts.missed
       : part.kind == Difference::invented ? counts.invented
                                           : counts.wronglyAttached);
  return counts;
}

QString places(const ReportNumbers& numbers, std::size_t count) {
  return count == 1 ? ReportText::tr("1 place")
                    : ReportText::tr("%1 places").arg(numbers.count(count));
}

QString whatIsNear(const ReportParts& parts) {
  const ReportNumbers& numbers = parts.numbers;
  const ToleranceScore& score = parts.data.score;
  return ReportText::tr("The plant has %1 of the length of the reference within %2, and %3 of its "
                        "own "
                        "length lies that near to the reference: F is %4.")
      .arg(numbers.percent(score.recall), numbers.givenLength(score.distance),
           numbers.percent(score.precision), numbers.share(score.f()));
}

QString whatDiffers(const ReportParts& parts) {
  const Differences& found = parts.data.differences;
  const ReportNumbers& numbers = parts.numbers;
  if (found.parts.empty())
    return ReportText::tr("No part of either is missed, invented or wrongly attached.");
  const Counts counts = countsOf(found);
  const QString attached =
      counts.wronglyAttached == 0   ? ReportText::tr("nothing is attached to the wrong wood")
      : counts.wronglyAttached == 1 ? ReportText::tr("1 part is attached to the wrong wood")
                                    : ReportText::tr("%1 parts are attached to the wrong wood")
                                          .arg(numbers.count(counts.wronglyAttached));
  return ReportText::tr("%1 are missed in %2 and %3 invented in %4; %5.")
      .arg(numbers.length(found.missed), places(numbers, counts.missed),
           numbers.length(found.invented), places(numbers, counts.invented), attached);
}

/// As the warning of the comparison, with the unit.
QString shiftText(const Registration& lay, const ReportNumbers& numbers) {
  const Eigen::Vector3d& shift = lay.shift;
  const QString by =
      ReportText::tr("(%1, %2, %3)")
          .arg(numbers.length(shift.x()), numbers.length(shift.y()), numbers.length(shift.z()));
  const QString off = numbers.length(shift.norm());
  if (lay.angle() == 0)
    return ReportText::tr("the plant lay %1 off the reference: it was moved by %2 to lie on it")
        .arg(off, by);
  const Eigen::Vector3d axis = lay.axis();
  return ReportText::tr(
             "the plant lay %1 off the reference: it was turned by %2 about (%3, %4, %5) and moved "
             "by %6 to lie on it")
      .arg(off, numbers.degrees(lay.angle()), numbers.share(axis.x()), numbers.share(axis.y()),
           numbers.share(axis.z()), by);
}

double f(const PartAgreement& part) {
  return harmonicMean(part.precision, part.recall);
}

/// Where it is best and where worst; empty where that would say nothing.
QString whereItDiffers(const ReportParts& parts) {
  const AgreementByPlace& byPlace = parts.data.comparison.byPlace;
  double whole = 0;
  for (const PartAgreement& part : byPlace.byOrder)
    whole += part.referenceLength;
  std::vector<PartAgreement> large; // the trunk, and no order of single twigs, or that one lacks
  for (const PartAgreement& part : byPlace.byOrder)
    if (const double both = std::min(part.resultLength, part.referenceLength);
        both > 0 && (part.from == 0 || both >= 0.03 * whole))
      large.push_back(part);
  if (large.size() < 2) return {};
  const auto [worst, best] = std::ranges::minmax_element(large, {}, f);
  if (f(*best) - f(*worst) < 0.01) return {};
  return ReportText::tr("Within %1 it agrees best in order %2 (F %3) and least in order %4 (F %5).")
      .arg(parts.numbers.givenLength(byPlace.distance), QString::number(best->from),
           parts.numbers.share(f(*best)), QString::number(worst->from),
           parts.numbers.share(f(*worst)));
}

/// Below a key number: its interval, or within which distance places count.
QString remarkOf(const Score& score, const ReportParts& parts) {
  const auto& intervals = parts.data.intervals.results.front().scores;
  const auto interval = intervals.find(score.key);
  if (interval != intervals.end()) return parts.numbers.range(interval->second);
  if (score.group != ScoreGroup::landmarks) return {};
  return ReportText::tr("within %1")
      .arg(parts.numbers.givenLength(parts.data.comparison.tips.distance));
}

ReportKeyNumbers keyNumbers(const ReportParts& parts) {
  ReportKeyNumbers shown;
  for (const Score* score : leadingFirst(scoresIn(inKeyNumbers))) {
    const auto& value = parts.data.comparison.scores.at(score->key);
    QString name = labelOf(*score);
    if (score->key == leadingScore)
      name =
          ReportText::tr("%1 within %2").arg(name, parts.numbers.givenLength(parts.data.tolerance));
    shown.numbers.push_back(
        {value ? parts.numbers.share(*value) : QStringLiteral("–"), name, remarkOf(*score, parts)});
  }
  return shown;
}

ReportTable errorTable(const ReportParts& parts, const QString& caption,
                       const std::vector<std::size_t>& errors) {
  const ReportNumbers& numbers = parts.numbers;
  ReportTable table;
  table.caption = caption;
  table.columns = {{ReportText::tr("no."), false},
                   {ReportText::tr("kind"), false},
                   {numbers.inUnit(ReportText::tr("length"))},
                   {numbers.inUnit(ReportText::tr("x"))},
                   {numbers.inUnit(ReportText::tr("y"))},
                   {numbers.inUnit(ReportText::tr("z"))}};
  for (const std::size_t i : errors) {
    const DifferingPart& part = parts.data.differences.parts[i];
    table.rows.push_back({{numbers.count(table.rows.size() + 1)},
                          {titleOf(part.kind)},
                          {numbers.number(part.length)},
                          {numbers.number(part.at.x())},
                          {numbers.number(part.at.y())},
                          {numbers.number(part.at.z())}});
  }
  return table;
}

} // namespace

QString scanText(const QString& name, const PointCloud& scan, UpAxis up,
                 const ReportNumbers& numbers) {
  const std::optional<Legend> heights = pointLegend(scan, PointColor::height, up);
  const QString colors =
      heights ? ReportText::tr("colored by height, from %1 (violet) to %2 (green)")
                    .arg(numbers.length(heights->from, 3), numbers.length(heights->to, 3))
              : ReportText::tr("all at one height");
  const auto points = static_cast<std::size_t>(scan.size());
  return points == 1 ? ReportText::tr("%1, 1 point, %2").arg(name, colors)
                     : ReportText::tr("%1, %2 points, %3").arg(name, numbers.count(points), colors);
}

ReportSection summarySection(const ReportParts& parts) {
  QStringList sentences = {whatIsNear(parts), whatDiffers(parts), whereItDiffers(parts)};
  sentences.removeAll(QString());
  ReportSection section{ReportText::tr("Summary"), {ReportParagraph{sentences.join(' ')}}};
  section.blocks.emplace_back(keyNumbers(parts));
  section.blocks.emplace_back(ReportParagraph{
      ReportText::tr("Under each score, its 95 % interval: the segments of the reference were "
                     "drawn again %1 times, "
                     "and the middle 95 % of the scores so found lie there.")
          .arg(parts.numbers.count(parts.data.intervals.draws)),
      ReportParagraph::Look::note});
  ReportWarnings warnings;
  const Comparison& comparison = parts.data.comparison;
  for (const ShownMessage& warning : comparison.warnings)
    warnings.lines.append(warning == comparison.shiftWarning
                              ? shiftText(*comparison.registration, parts.numbers)
                              : shownText(warning));
  if (parts.about.scale != 1)
    warnings.lines.append(ReportText::tr("the plant was multiplied by %1 first")
                              .arg(parts.numbers.given(parts.about.scale)));
  if (!parts.pictures.problem.isEmpty())
    warnings.lines.append(ReportText::tr("there are no pictures: %1").arg(parts.pictures.problem));
  if (!warnings.lines.isEmpty()) section.blocks.emplace_back(std::move(warnings));
  return section;
}

ReportSection plantsSection(const ReportParts& parts) {
  const Differences& found = parts.data.differences;
  const ReportNumbers& numbers = parts.numbers;
  const Counts counts = countsOf(found);
  const auto entry = [&](Difference kind, const QString& text) {
    const Color color = colorOf(kind);
    return ReportLegend::Entry{titleOf(kind), QColor(color[0], color[1], color[2]), text};
  };
  ReportSection section{ReportText::tr("Both plants"), {}};
  section.blocks.emplace_back(ReportLegend{
      {entry(Difference::matched,
             ReportText::tr("%1 of the plant").arg(numbers.length(found.matchedInResult))),
       entry(Difference::missed,
             ReportText::tr("%1 of the reference, dotted; %2")
                 .arg(numbers.length(found.missed), places(numbers, counts.missed))),
       entry(Difference::invented,
             ReportText::tr("%1 of the plant; %2")
                 .arg(numbers.length(found.invented), places(numbers, counts.invented))),
       entry(Difference::wronglyAttached, places(numbers, counts.wronglyAttached))}});
  const auto add = [&](int across, const std::vector<ReportFigures::Figure>& figures) {
    ReportFigures shown{.across = across, .figures = {}};
    for (const auto& figure : figures)
      if (!figure.image.isNull()) shown.figures.push_back(figure);
    if (!shown.figures.empty()) section.blocks.emplace_back(std::move(shown));
  };
  const ReportPictures& pictures = parts.pictures;
  add(2, {{pictures.front, ReportText::tr("What differs, from the front"),
           ReportText::tr("The plant, and what it misses of the reference")},
          {pictures.side, ReportText::tr("What differs, from the right"),
           ReportText::tr("The same from the side")}});
  add(parts.data.scan ? 3 : 2,
      {{pictures.result, ReportText::tr("The plant"), parts.about.result.name},
       {pictures.reference, ReportText::tr("The reference"), parts.about.reference.name},
       {pictures.scan, ReportText::tr("The scan"),
        parts.about.scan
            ? scanText(parts.about.scan->name, *parts.data.scan, parts.about.up, numbers)
            : QString()}});
  return section;
}

ReportSection errorsSection(const ReportParts& parts) {
  const auto& all = parts.data.differences.parts;
  const ReportNumbers& numbers = parts.numbers;
  const std::vector<std::size_t> shown = shownErrors(parts.data);
  const std::vector<std::size_t>& ignored = parts.data.ignored;
  ReportSection section{ReportText::tr("Largest errors"), {}};
  if (all.empty()) {
    section.blocks.emplace_back(
        ReportParagraph{ReportText::tr("There are none at this tolerance.")});
    return section;
  }
  if (!shown.empty())
    section.blocks.emplace_back(ReportParagraph{
        ReportText::tr(
            "%1 of %2: the longest of each kind. Of what is wrongly attached, all that it carries "
            "counts. Rings: where it begins; dashed, where the reference attaches it.")
            .arg(numbers.count(shown.size()), numbers.count(all.size() - ignored.size()))});
  ReportFigures figures{.across = 3, .figures = {}};
  for (std::size_t i = 0; i < std::min(shown.size(), parts.pictures.errors.size()); ++i) {
    const DifferingPart& part = all[shown[i]];
    figures.figures.push_back(
        {parts.pictures.errors[i],
         ReportText::tr("%1. %2").arg(numbers.count(i + 1), titleOf(part.kind)),
         ReportText::tr("%1 long").arg(numbers.length(part.length))});
  }
  if (!figures.figures.empty()) section.blocks.emplace_back(std::move(figures));
  if (!shown.empty())
    section.blocks.emplace_back(errorTable(
        parts, ReportText::tr("Where they begin, in the frame of the reference"), shown));
  if (ignored.empty()) return section;
  section.blocks.emplace_back(ReportParagraph{
      ignored.size() == 1
          ? ReportText::tr("1 more was looked at and is ignored. All scores and lengths count it.")
          : ReportText::tr(
                "%1 more were looked at and are ignored. All scores and lengths count them.")
                .arg(numbers.count(ignored.size()))});
  section.blocks.emplace_back(errorTable(parts, ReportText::tr("Ignored"), ignored));
  return section;
}

} // namespace espalier
