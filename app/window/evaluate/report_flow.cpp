#include "app/window/evaluate/report_flow.h"

#include "app/report/write_report.h"
#include "app/window/evaluate/reference_flow.h"
#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/files/reported_plant.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/evaluate/comparison_options.h"
#include "core/io/atomic_file.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_slot.h"

#include <QAction>
#include <QCoreApplication>
#include <QDate>
#include <QFileDialog>
#include <QMainWindow>

#include <memory>
#include <utility>

namespace espalier {
namespace {

using Made = std::pair<ReportAbout, ReportData>;

/// The plant lies as in the panels, so that both say the same.
ComparisonOptions comparedAs(const EvaluationOptions& how, const Skeleton& result,
                             const Skeleton& reference, const Progress& progress) {
  ComparisonOptions options;
  options.registers = how.registers;
  if (how.registers)
    options.registration.motion = referenceMotion(result, reference, how, progress).inverse();
  options.edit = how.edit;
  options.breastHeight = how.breastHeight;
  options.scan = how.scan;
  return withTolerance(options, reference, how.tolerance);
}

} // namespace

ReportFlow::ReportFlow(Parts parts) : parts_(std::move(parts)), maker_(parts_.jobs) {
  parts_.window.actions.add(
      {.id = "export_report",
       .text = tr("Export Report…"),
       .help = tr("Writes how the plant agrees with its reference, with pictures, as HTML or PDF")},
      [this] { choose(); });
  connect(&maker_, &ReportMaker::busyChanged, this, &ReportFlow::refresh);
  connect(&maker_, &ReportMaker::noted, this, &ReportFlow::noted);
  connect(&maker_, &ReportMaker::written, this, &ReportFlow::written);
  refresh();
}

void ReportFlow::refresh() {
  parts_.window.actions["export_report"]->setEnabled(!maker_.isBusy() &&
                                                     parts_.reference.skeleton() != nullptr &&
                                                     !parts_.document.skeleton().isEmpty());
}

void ReportFlow::choose() {
  QFileDialog dialog(&parts_.window.window, tr("Export the report"), {},
                     tr("Web pages (*.html);;PDF (*.pdf)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("html");
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.contains(QLatin1String("pdf")) ? "pdf" : "html");
  });
  proposeBeside(dialog, parts_.document, ".report.html");
  if (dialog.exec() == QDialog::Accepted) write(dialog.selectedFiles().front());
}

ReportAbout ReportFlow::about() const {
  const PlantDocument& document = parts_.document;
  ReportAbout about;
  about.result = reportedPlant(document);
  about.reference = {parts_.reference.name(), fingerprintOf(*parts_.reference.skeleton()),
                     about.result.note};
  about.scan = reportedScan(document);
  about.date = QDate::currentDate().toString(Qt::ISODate);
  about.version = QCoreApplication::applicationVersion();
  about.unit = symbol(document.unit());
  const EvaluationOptions how = parts_.how();
  about.distance = how.tolerance;
  about.turns = how.turns;
  about.up = how.up;
  about.edit = how.edit;
  about.made = made_;
  about.choices = choices_;
  about.handWork = handWork(document);
  return about;
}

void ReportFlow::write(const QString& path) {
  maker_.requireIdle();
  requireReportName(toPath(path));
  requireWritable(toPath(path));
  parts_.jobs.start(
      tr("Measuring for the report"),
      [result = parts_.document.skeleton(), reference = parts_.reference.skeleton(),
       how = parts_.how(), ignored = ignored_, description = about(),
       scan = toPath(parts_.document.scanPath())](const Progress& progress) mutable {
        Comparison comparison =
            compare(result, *reference, comparedAs(how, result, *reference, progress.part(0, 0.2)),
                    progress.part(0.2, 0.6));
        ReportData data = reportData(std::move(comparison), result, *reference, how.scan.cloud,
                                     how.tolerance, progress.part(0.6, 1));
        ignore(data, ignored);
        identifyScan(description.scan, scan, progress);
        return std::make_shared<const Made>(std::move(description), std::move(data));
      },
      [this, path](const std::shared_ptr<const Made>& made) {
        parts_.jobs.afterwards([this, path, made] {
          const auto& [about, data] = *made;
          maker_.start(path, std::make_unique<PictureSession>(data, about.up, about.unit),
                       [path, made](const ReportPictures& pictures) {
                         writeReport(toPath(path),
                                     comparisonReport(made->second, pictures, made->first));
                       });
        });
      });
}

} // namespace espalier
