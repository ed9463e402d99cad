#include "app/report/comparison_report.h"

#include "app/report/report_sections.h"
#include "core/base/error.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace espalier {

ReportedFile reportedFile(const std::filesystem::path& path, const Progress& progress) {
  constexpr qint64 atOnce = 1 << 20; // bytes
  const QString name = QString::fromStdString(path.string());
  QFile file(name);
  QCryptographicHash hash(QCryptographicHash::Sha256);
  bool isRead = file.open(QIODevice::ReadOnly);
  while (isRead && !file.atEnd()) {
    progress.check();
    const QByteArray bytes = file.read(atOnce);
    isRead = !bytes.isEmpty();
    hash.addData(bytes);
  }
  if (!isRead) throw Error(path.string() + ": " + file.errorString().toStdString());
  return {QFileInfo(name).fileName(), QString::fromLatin1(hash.result().toHex()), {}, name};
}

Report comparisonReport(const ReportData& data, const ReportPictures& pictures,
                        const ReportAbout& about) {
  const ReportParts parts{data, pictures, about, ReportNumbers(about.unit)};
  Report report;
  report.title = ReportText::tr("%1 compared with %2").arg(about.result.name, about.reference.name);
  report.facts = {about.date, ReportText::tr("Espalier %1").arg(about.version)};
  report.facts.append(about.unit.isEmpty() ? ReportText::tr("lengths in the unit of the files")
                                           : ReportText::tr("lengths in %1").arg(about.unit));
  for (const auto& section : {summarySection, plantsSection, errorsSection, toleranceSection,
                              indicesSection, placesSection, woodSection, traitsSection})
    report.sections.push_back(section(parts));
  if (about.made) report.sections.push_back(makingSection(parts));
  if (!about.choices.empty()) report.sections.push_back(choicesSection(about.choices));
  if (about.handWork) report.sections.push_back(handWorkSection(*about.handWork, parts.numbers));
  report.sections.push_back(settingsSection(parts));
  report.sections.push_back(methodsSection(parts));
  return report;
}

} // namespace espalier
