#include "app/cli/evaluate_report.h"

#include "app/about/version.h"
#include "app/cli/arguments.h"
#include "app/cli/files.h"
#include "app/cli/headless.h"
#include "app/cli/terminal.h"
#include "app/report/comparison_report.h"
#include "app/report/write_report.h"
#include "core/io/formats.h"

#include <QDate>

#include <memory>

namespace espalier {
namespace {

ReportAbout aboutOf(const ReportFlags& flags, const ReportSubject& subject) {
  ReportAbout about;
  about.result = reportedFile(subject.resultFile);
  about.reference = reportedFile(subject.referenceFile);
  if (!flags.scan.empty()) about.scan = reportedFile(flags.scan);
  about.date = QDate::currentDate().toString(Qt::ISODate);
  about.version = QString::fromStdString(programVersion());
  about.unit = QString::fromStdString(subject.unit);
  about.scale = subject.scale;
  about.distance = subject.distance;
  about.turns = subject.registration.turns;
  about.up = subject.registration.up;
  about.edit = subject.edit;
  return about;
}

} // namespace

void addReport(CLI::App& command, ReportFlags& flags) {
  command
      .add_option("--report", flags.file,
                  "Report to write, HTML or PDF, with pictures, curves and all tables")
      ->type_name("FILE");
  command
      .add_option("--scan", flags.scan,
                  "Points of the plant, which the report shows; radii are compared by how much of "
                  "the circumference was seen")
      ->type_name("FILE");
}

void requireReport(const ReportFlags& flags, const std::vector<std::string>& inputs) {
  if (flags.file.empty()) return;
  requireReportName(flags.file);
  std::vector<std::string> read = inputs;
  if (!flags.scan.empty()) read.push_back(flags.scan);
  requireOutput(flags.file, read);
}

std::shared_ptr<const PointCloud> scanFor(const ReportFlags& flags, const Progress& progress) {
  if (flags.scan.empty()) return nullptr;
  Imported<PointCloud> points = readPoints(flags.scan, progress);
  printNotes(points.notes);
  return std::make_shared<const PointCloud>(std::move(points.value));
}

void writeReport(const ReportFlags& flags, const ReportData& data, const ReportSubject& subject,
                 const Progress& progress) {
  const ReportAbout about = aboutOf(flags, subject);
  const Headless headless;
  const Progress drawing = progress.part(0, 0.95, "Drawing");
  PictureSession session(data, about.up, about.unit);
  do
    drawing.update(session.done());
  while (session.drawNext());
  const Report report = comparisonReport(data, session.pictures(), about);
  progress.update(0.95);
  writeReport(flags.file, report);
  printWritten(flags.file);
}

void writeReport(const ReportFlags& flags, const RankingReportData& data,
                 const RankingSubject& subject) {
  RankingReportAbout about;
  for (const std::string& file : subject.resultFiles)
    about.results.push_back(reportedFile(file));
  about.reference = reportedFile(subject.referenceFile);
  about.date = QDate::currentDate().toString(Qt::ISODate);
  about.version = QString::fromStdString(programVersion());
  about.unit = QString::fromStdString(subject.unit);
  about.scale = subject.scale;
  for (const std::string& note : subject.notes)
    about.notes.append(QString::fromStdString(note));
  const Headless headless;
  writeReport(flags.file, rankingReport(data, about));
  printWritten(flags.file);
}

} // namespace espalier
