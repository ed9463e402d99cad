#pragma once

#include "app/report/comparison_report.h"
#include "app/report/report_numbers.h"
#include "core/evaluate/trait_rows.h"
#include "ui/panels/score_text.h"

#include <QCoreApplication>

#include <optional>
#include <utility>
#include <vector>

namespace espalier {

/// What the sections of a report are made of.
struct ReportParts {
  const ReportData& data;
  const ReportPictures& pictures;
  const ReportAbout& about;
  ReportNumbers numbers;
};

[[nodiscard]] ReportSection summarySection(const ReportParts& parts);
[[nodiscard]] ReportSection plantsSection(const ReportParts& parts);
[[nodiscard]] ReportSection errorsSection(const ReportParts& parts);
[[nodiscard]] ReportSection toleranceSection(const ReportParts& parts);
[[nodiscard]] ReportSection indicesSection(const ReportParts& parts);
[[nodiscard]] ReportSection placesSection(const ReportParts& parts);
[[nodiscard]] ReportSection woodSection(const ReportParts& parts);
[[nodiscard]] ReportSection traitsSection(const ReportParts& parts);
[[nodiscard]] ReportSection handWorkSection(const HandWork& work, const ReportNumbers& numbers);
[[nodiscard]] ReportSection makingSection(const ReportParts& parts); // pre: about.made
[[nodiscard]] ReportSection settingsSection(const ReportParts& parts);
[[nodiscard]] ReportSection methodsSection(const ReportParts& parts);

/// Below the picture of a scan: what it is, and what its colors mean.
[[nodiscard]] QString scanText(const QString& name, const PointCloud& scan, UpAxis up,
                               const ReportNumbers& numbers);
/// A score with its unit, as in the first column of a table.
[[nodiscard]] QString nameInUnit(const Score& score, const ReportNumbers& numbers);
[[nodiscard]] QString valueText(const Score& score, const std::optional<double>& value,
                                const ReportNumbers& numbers); // a dash for none
/// A trait with its unit, as in the first column of a table: "stem length [mm]".
[[nodiscard]] QString nameOf(const TraitRow& row, const ReportNumbers& numbers);
/// What was read, by its role.
[[nodiscard]] ReportTable inputsTable(const std::vector<std::pair<QString, ReportedFile>>& inputs);
/// A word as it is typed in a command, in quotes if it needs them.
[[nodiscard]] QString typedWord(const QString& word);
/// The very numbers, with commas between; zero has no sign.
[[nodiscard]] QString typedNumbers(const Eigen::VectorXd& values);
/// A file as it is typed in a command; one that is to be exported first has a name of its own.
[[nodiscard]] QString typedName(const ReportedFile& file);
/// Says to export it first; empty: it is a file already.
[[nodiscard]] std::vector<ReportBlock> exportAdvice(const ReportedFile& file);
/// What the traits and the light of one plant mean.
[[nodiscard]] std::vector<ReportTerms::Term> traitTerms(bool hasLight);

/// What the scores of a ranking mean.
[[nodiscard]] ReportTerms scoreTerms();

/// Gives texts in the language of the reader.
struct ReportText {
  Q_DECLARE_TR_FUNCTIONS(Report)
};

} // namespace espalier
