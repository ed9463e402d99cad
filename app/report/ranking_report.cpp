#include "app/report/ranking_report.h"

#include "app/report/report_sections.h"
#include "core/evaluate/evaluation.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

struct RankingParts {
  const RankingReportData& data;
  const RankingReportAbout& about;
  ReportNumbers numbers;
};

QString nameOf(const RankingParts& parts, const RankedResult& result) {
  return parts.about.results.at(result.result).name;
}

ReportTable scoreTable(const RankingParts& parts, const QString& caption, ScoreGroup group) {
  ScoreList scores = leadingFirst(rankedScores());
  std::erase_if(scores, [group](const Score* score) { return score->group != group; });
  ReportTable table;
  table.caption = caption;
  table.columns = {{ReportText::tr("rank")}, {ReportText::tr("structure"), false}};
  for (const Score* score : scores) {
    table.columns.push_back({symbolOf(*score)});
    table.columns.push_back({ReportText::tr("interval"), false});
  }
  for (const RankedResult& result : parts.data.ranking.results) {
    table.rows.push_back({{parts.numbers.count(table.rows.size() + 1)}, {nameOf(parts, result)}});
    for (const Score* score : scores) {
      const ScoreInterval& interval = result.scores.at(score->key);
      table.rows.back().push_back({parts.numbers.share(interval.value), interval.value});
      table.rows.back().push_back({parts.numbers.range(interval)});
    }
  }
  return table;
}

ReportSection ranks(const RankingParts& parts) {
  const Ranking& ranking = parts.data.ranking;
  ReportTable table;
  table.columns = {{ReportText::tr("rank")},
                   {ReportText::tr("structure"), false},
                   {symbolOf(scoreOf(ranking.by))},
                   {ReportText::tr("interval"), false},
                   {ReportText::tr("beats the next")}};
  for (const RankedResult& result : ranking.results) {
    const ScoreInterval& interval = result.scores.at(ranking.by);
    table.rows.push_back(
        {{parts.numbers.count(table.rows.size() + 1)},
         {nameOf(parts, result)},
         {parts.numbers.share(interval.value), interval.value},
         {parts.numbers.range(interval)},
         {result.aboveNext ? parts.numbers.percent(*result.aboveNext) : QStringLiteral("–")}});
  }
  ReportSection section{ReportText::tr("Ranking"), {}};
  section.blocks.emplace_back(ReportParagraph{
      ReportText::tr("By %1, within %2.")
          .arg(symbolOf(scoreOf(ranking.by)), parts.numbers.givenLength(ranking.distance))});
  section.blocks.emplace_back(std::move(table));
  section.blocks.emplace_back(ReportParagraph{
      ReportText::tr(
          "The segments of the reference were drawn again %1 times, all structures from the same "
          "draws. "
          "An interval holds the middle %2 of the scores. \"Beats the next\" is the share of draws "
          "in "
          "which a structure is above the one after it: near 50 %, the two cannot be "
          "distinguished.")
          .arg(parts.numbers.count(ranking.draws), parts.numbers.percent(ranking.confidence)),
      ReportParagraph::Look::note});
  if (!parts.about.notes.isEmpty()) section.blocks.emplace_back(ReportWarnings{parts.about.notes});
  return section;
}

ReportSection scoreSection(const RankingParts& parts) {
  ReportSection section{ReportText::tr("Scores"), {}};
  const std::vector<std::pair<ScoreGroup, QString>> captions = {
      {ScoreGroup::nearness, ReportText::tr("What lies near")},
      {ScoreGroup::segments, ReportText::tr("As the authors of the method measure")},
      {ScoreGroup::capped, ReportText::tr("Matched within the distance only")},
      {ScoreGroup::landmarks, ReportText::tr("Tips and branchings")},
      {ScoreGroup::network, ReportText::tr("Missed and invented")},
      {ScoreGroup::architecture, ReportText::tr("Orders, axes and edges")},
      {ScoreGroup::edits, ReportText::tr("Edits")},
      {ScoreGroup::radii, ReportText::tr("Radii")}};
  for (const auto& [group, caption] : captions)
    if (ReportTable table = scoreTable(parts, caption, group); table.columns.size() > 2)
      section.blocks.emplace_back(std::move(table));
  return section;
}

ReportSection curves(const RankingParts& parts) {
  ReportSection section{ReportText::tr("Agreement over the tolerance"), {}};
  for (std::size_t i = 0; i < parts.data.curves.size(); ++i) {
    const RankedResult& result = parts.data.ranking.results[i];
    ReportPlot plot;
    plot.size = {380, 230};
    plot.text = ReportText::tr("%1. %2: precision, recall and F")
                    .arg(parts.numbers.count(i + 1), nameOf(parts, result));
    plot.paint = [curve = TolerancePlot{.curve = parts.data.curves[i],
                                        .chosen = parts.data.chosen[i],
                                        .unit = parts.about.unit}](
                     QPainter& painter, const QRectF& box, const PlotColors& colors) {
      curve.paint(painter, box, colors);
    };
    section.blocks.emplace_back(std::move(plot));
  }
  return section;
}

ReportSection origin(const RankingParts& parts) {
  ReportTable inputs;
  inputs.caption = ReportText::tr("Inputs");
  inputs.columns = {{ReportText::tr("role"), false},
                    {ReportText::tr("file"), false},
                    {parts.numbers.inUnit(ReportText::tr("shifted by"))},
                    {ReportText::tr("turned by")},
                    {ReportText::tr("SHA-256"), false}};
  for (const RankedResult& result : parts.data.ranking.results) {
    const ReportedFile& file = parts.about.results.at(result.result);
    const Registration lay = result.registration.value_or(Registration());
    inputs.rows.push_back({{ReportText::tr("structure")},
                           {file.name},
                           {parts.numbers.number(lay.shift.norm())},
                           {parts.numbers.degrees(lay.angle())},
                           {file.fingerprint}});
  }
  inputs.rows.push_back({{ReportText::tr("reference")},
                         {parts.about.reference.name},
                         {QStringLiteral("–")},
                         {QStringLiteral("–")},
                         {parts.about.reference.fingerprint}});
  ReportTable settings;
  settings.caption = ReportText::tr("Settings");
  settings.columns = {{ReportText::tr("setting"), false}, {ReportText::tr("value"), false}};
  const Ranking& ranking = parts.data.ranking;
  settings.rows = {
      {{ReportText::tr("registration")},
       {parts.data.isRegistered
            ? ReportText::tr(
                  "each structure was laid on the reference; its row says how far it was turned")
            : ReportText::tr("none: compared where they lie")}},
      {{ReportText::tr("scale of the structures")}, {parts.numbers.given(parts.about.scale)}},
      {{ReportText::tr("tolerance")}, {parts.numbers.givenLength(ranking.distance)}},
      {{ReportText::tr("draws for the intervals")},
       {ReportText::tr("%1, seed %2").arg(parts.numbers.count(ranking.draws)).arg(ranking.seed)}},
      {{ReportText::tr("version")},
       {ReportText::tr("Espalier %1, Qt %2").arg(parts.about.version, qVersion())}}};
  return {ReportText::tr("How it was measured"), {std::move(inputs), std::move(settings)}};
}

} // namespace

RankingReportData rankingReportData(Ranking ranking, const std::vector<Skeleton>& results,
                                    const Skeleton& reference, bool isRegistered,
                                    const Progress& progress) {
  RankingReportData data{std::move(ranking), {}, {}, isRegistered};
  std::vector<double> distances =
      curveDistances(data.ranking.distance, defaultTolerances(reference).back());
  distances.push_back(data.ranking.distance);
  const auto all = static_cast<double>(data.ranking.results.size());
  for (const RankedResult& result : data.ranking.results) {
    const auto done = static_cast<double>(data.curves.size());
    const Eigen::Isometry3d motion = result.registration.value_or(Registration()).motion;
    data.curves.push_back(toleranceCurve(moved(results.at(result.result), motion), reference,
                                         {.distances = distances},
                                         progress.part(done / all, (done + 1) / all))
                              .scores);
    data.chosen.push_back(data.curves.back().back());
    data.curves.back().pop_back();
  }
  return data;
}

Report rankingReport(const RankingReportData& data, const RankingReportAbout& about) {
  const RankingParts parts{data, about, ReportNumbers(about.unit)};
  Report report;
  report.title = ReportText::tr("%1 structures compared with %2")
                     .arg(parts.numbers.count(about.results.size()), about.reference.name);
  report.facts = {about.date, ReportText::tr("Espalier %1").arg(about.version),
                  about.unit.isEmpty() ? ReportText::tr("lengths in the unit of the files")
                                       : ReportText::tr("lengths in %1").arg(about.unit)};
  report.sections = {ranks(parts),
                     scoreSection(parts),
                     curves(parts),
                     origin(parts),
                     {ReportText::tr("Methods"), {scoreTerms()}}};
  return report;
}

} // namespace espalier
