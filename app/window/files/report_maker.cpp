#include "app/window/files/report_maker.h"

#include "core/base/error.h"
#include "ui/jobs/job_slot.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QTimer>
#include <QUrl>

#include <utility>

namespace espalier {

ReportMaker::ReportMaker(JobSlot& jobs, QObject* parent) : QObject(parent), jobs_(jobs) {}

void ReportMaker::requireIdle() const {
  if (isBusy())
    throw Error(tr("The report is still being written: wait for it, or cancel it").toStdString());
  jobs_.requireIdle();
}

void ReportMaker::start(const QString& path, std::unique_ptr<PictureSession> pictures,
                        Write write) {
  path_ = path;
  pictures_ = std::move(pictures);
  write_ = std::move(write);
  emit busyChanged();
  if (!pictures_) return save();
  emit noted(tr("Drawing the pictures of %1…").arg(QFileInfo(path_).fileName()));
  QTimer::singleShot(0, this, &ReportMaker::drawNext);
}

void ReportMaker::drawNext() {
  if (pictures_->drawNext())
    QTimer::singleShot(0, this, &ReportMaker::drawNext);
  else
    save();
}

void ReportMaker::save() {
  const QString file = QFileInfo(path_).fileName();
  const std::unique_ptr<PictureSession> session = std::move(pictures_);
  Write write = std::exchange(write_, nullptr);
  emit busyChanged();
  if (jobs_.isBusy()) {
    emit noted(tr("%1 was not written: another job began; export it again").arg(file));
    return;
  }
  jobs_.start(
      tr("Writing %1").arg(file),
      [write = std::move(write),
       pictures = session ? session->pictures() : ReportPictures()](const Progress& progress) {
        progress.update(0.2);
        write(pictures);
        return true;
      },
      [this, file, path = path_](bool /*isWritten*/) {
        emit noted(tr("Wrote %1").arg(file));
        emit written(path);
      });
}

Notice offerToOpen(const QString& path, std::function<void(const QString&)> fails) {
  const QString file = QFileInfo(path).fileName();
  return {.text = ReportMaker::tr("Wrote %1").arg(file),
          .actions = {{ReportMaker::tr("Open"), [path, file, fails = std::move(fails)] {
                         if (!QDesktopServices::openUrl(QUrl::fromLocalFile(path)))
                           fails(ReportMaker::tr("No program opens %1 from here").arg(file));
                       }}}};
}

} // namespace espalier
