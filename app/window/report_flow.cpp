#include "app/window/report_flow.h"

#include "app/report/write_report.h"
#include "app/window/action_set.h"
#include "app/window/file_filters.h"
#include "app/window/load_files.h"
#include "app/window/reference_flow.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/node_list.h"
#include "core/project/project.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_runner.h"

#include <QAction>
#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDate>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QTimer>

#include <filesystem>
#include <sstream>
#include <utility>

namespace espalier {
namespace {

/// SHA-256 of a structure as it is now, which need not be that of any file.
QString fingerprintOf(const Skeleton& skeleton) {
  std::ostringstream text;
  writeNodeList(text, skeleton);
  const std::string bytes = text.str();
  return QString::fromLatin1(
      QCryptographicHash::hash(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())),
                               QCryptographicHash::Sha256)
          .toHex());
}

/// Tells the file that the points came from, as it lies now, if it can still be read.
void identifyScan(ReportAbout& about, const std::filesystem::path& path, const Progress& progress) {
  if (!about.scan || path.empty()) return;
  try {
    about.scan = reportedFile(path, progress);
  } catch (const Error&) {
    about.scan->note = ReportFlow::tr("the file can no longer be read");
  }
}

/// The plant lies as in the panels, so that both tell the same.
ComparisonOptions comparedAs(const EvaluationOptions& how, const Skeleton& result,
                             const Skeleton& reference, const Progress& progress) {
  ComparisonOptions options;
  options.registers = how.registers;
  if (how.registers)
    options.registration.motion = referenceMotion(result, reference, how, progress).inverse();
  options.breastHeight = how.breastHeight;
  options.scan = how.scan;
  return withTolerance(options, reference, how.tolerance);
}

} // namespace

struct ReportFlow::Making {
  QString path;
  ReportAbout about;
  ReportData data;
  std::unique_ptr<PictureSession> pictures;
};

ReportFlow::ReportFlow(Parts parts) : parts_(std::move(parts)) {
  parts_.window.actions.add(
      {.id = "export_report",
       .text = tr("Export Report…"),
       .help = tr("Writes how the plant agrees with its reference, with pictures, as HTML or PDF")},
      [this] { choose(); });
  refresh();
}

ReportFlow::~ReportFlow() = default;

void ReportFlow::refresh() {
  parts_.window.actions["export_report"]->setEnabled(
      !making_ && parts_.reference.skeleton() != nullptr && !parts_.document.skeleton().isEmpty());
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
  const QString note = tr("hashed as a node list");
  const QString name = QFileInfo(document.filePath()).fileName();
  ReportAbout about;
  const QString scan = QFileInfo(document.scanPath()).fileName();
  const QString unnamed = scan.isEmpty() ? tr("plant") : tr("plant of %1").arg(scan);
  about.result = {name.isEmpty() ? unnamed : name, fingerprintOf(document.skeleton()), note};
  about.result.isToExport =
      name.isEmpty() || document.isModified() || isProject(toPath(document.filePath()));
  about.reference = {parts_.reference.name(), fingerprintOf(*parts_.reference.skeleton()), note};
  if (document.scan() != nullptr)
    about.scan = ReportedFile{.name = scan.isEmpty() ? tr("points of the plant") : scan};
  about.date = QDate::currentDate().toString(Qt::ISODate);
  about.version = QCoreApplication::applicationVersion();
  about.unit = symbol(document.unit());
  about.distance = parts_.how().tolerance;
  about.choices = choices_;
  about.handWork = handWork(document);
  return about;
}

void ReportFlow::write(const QString& path) {
  if (parts_.jobs.isRunning() || making_)
    throw Error(tr("%1 is still running: wait for it, or cancel it")
                    .arg(making_ ? tr("The report") : parts_.jobs.name())
                    .toStdString());
  requireReportName(toPath(path));
  requireWritable(toPath(path));
  parts_.jobs.start(
      tr("Measuring for the report"),
      [result = parts_.document.skeleton(), reference = parts_.reference.skeleton(),
       how = parts_.how(), ignored = ignored_, told = about(),
       scan = toPath(parts_.document.scanPath())](const Progress& progress) mutable {
        Comparison comparison =
            compare(result, *reference, comparedAs(how, result, *reference, progress.part(0, 0.2)),
                    progress.part(0.2, 0.6));
        ReportData data = reportData(std::move(comparison), result, *reference, how.scan.cloud,
                                     how.tolerance, progress.part(0.6, 1));
        ignore(data, ignored);
        identifyScan(told, scan, progress);
        return std::pair(std::move(told), std::move(data));
      },
      [this, path](std::pair<ReportAbout, ReportData> made) {
        making_ = std::make_unique<Making>(
            Making{path, std::move(made.first), std::move(made.second), nullptr});
        refresh();
        parts_.jobs.afterwards([this] {
          emit noted(tr("Drawing the pictures of %1…").arg(QFileInfo(making_->path).fileName()));
          making_->pictures = std::make_unique<PictureSession>(making_->data, making_->about.unit);
          QTimer::singleShot(0, this, &ReportFlow::drawNext);
        });
      });
}

void ReportFlow::drawNext() {
  if (making_->pictures->drawNext())
    QTimer::singleShot(0, this, &ReportFlow::drawNext);
  else
    save();
}

void ReportFlow::save() {
  const std::shared_ptr<const Making> made(std::move(making_));
  refresh();
  const QString file = QFileInfo(made->path).fileName();
  if (parts_.jobs.isRunning()) {
    emit noted(tr("%1 was not written: another job began; export it again").arg(file));
    return;
  }
  parts_.jobs.start(
      tr("Writing %1").arg(file),
      [made](const Progress& progress) {
        const Report report = comparisonReport(made->data, made->pictures->pictures(), made->about);
        progress.update(0.2);
        writeReport(toPath(made->path), report);
        return true;
      },
      [this, file, path = made->path](bool /*isWritten*/) {
        emit noted(tr("Wrote %1").arg(file));
        emit written(path);
      });
}

} // namespace espalier
