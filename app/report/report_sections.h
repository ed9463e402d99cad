#pragma once

#include "app/report/comparison_report.h"
#include "app/report/report_numbers.h"

#include <QCoreApplication>

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
[[nodiscard]] ReportSection handWorkSection(const ReportParts& parts); // pre: there is a history
[[nodiscard]] ReportSection settingsSection(const ReportParts& parts);
[[nodiscard]] ReportSection methodsSection(const ReportParts& parts);

/// What the scores of a ranking mean.
[[nodiscard]] ReportTerms scoreTerms();

/// The text in the language of the reader.
[[nodiscard]] inline QString reportText(const char* text) {
  return QCoreApplication::translate("Report", text);
}

} // namespace espalier
