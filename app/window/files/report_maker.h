#pragma once

#include "app/report/report_pictures.h"
#include "app/window/frame/window_part.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>

namespace espalier {

class JobSlot;

/// What comes after the measuring of a report: its pictures are drawn one by one between what else
/// the window does, and writing is a job.
class ReportMaker : public QObject {
  Q_OBJECT

public:
  using Write = std::function<void(const ReportPictures&)>; // on the thread of the job; may throw

  explicit ReportMaker(JobSlot& jobs, QObject* parent = nullptr);

  [[nodiscard]] bool isBusy() const { return write_ != nullptr; }
  /// @throws Error if this or a job is busy
  void requireIdle() const;
  /// @param pictures null: there are none to draw
  /// pre: !isBusy(), and no job runs
  void start(const QString& path, std::unique_ptr<PictureSession> pictures, Write write);

signals:
  void busyChanged();
  void noted(const QString& message);
  void written(const QString& path);

private:
  void drawNext();
  void save();

  JobSlot& jobs_;
  QString path_;
  std::unique_ptr<PictureSession> pictures_;
  Write write_;
};

/// That a report was written, with an offer to open it; `fails` gets why that is not possible.
[[nodiscard]] Notice offerToOpen(const QString& path, std::function<void(const QString&)> fails);

} // namespace espalier
