#pragma once

#include "app/report/comparison_report.h"
#include "core/evaluate/study/ranking.h"

#include <vector>

namespace espalier {

/// What a report of several results against one reference is made of.
struct RankingReportData {
  Ranking ranking;
  std::vector<std::vector<ToleranceScore>> curves; // by ranking.results, at even distances
  std::vector<ToleranceScore> chosen;              // likewise, at the distance of the ranking
  bool isRegistered = true;
};

/// Measures what a report shows beyond a ranking.
/// @param results as they were ranked: where they lay
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: toleranceCurve() of each.
[[nodiscard]] RankingReportData rankingReportData(Ranking ranking,
                                                  const std::vector<Skeleton>& results,
                                                  const Skeleton& reference, bool isRegistered,
                                                  const Progress& progress = {});

/// What the report states beside its numbers.
struct RankingReportAbout {
  std::vector<ReportedFile> results; // as they were given
  ReportedFile reference;
  QString date;      // as it is to be written
  QString version;   // of the program
  QString unit;      // of lengths: "mm"; empty: not known
  double scale = 1;  // that the results were multiplied by
  QStringList notes; // what makes the numbers doubtful, a line each
};

/// Table, intervals and curves of a ranking. Deterministic: it reads no clock.
[[nodiscard]] Report rankingReport(const RankingReportData& data, const RankingReportAbout& about);

} // namespace espalier
