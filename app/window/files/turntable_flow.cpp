#include "app/window/files/turntable_flow.h"

#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "ui/document/manual_place.h"
#include "ui/jobs/job_slot.h"
#include "ui/view/animated_png.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

namespace espalier {

/// Pictures on their way from the window, which draws them, to the job, which writes them.
class TurntableFrames {
public:
  /// By the job. @throws what give() was called with, and Cancelled
  QImage take(int number, const Progress& progress) {
    std::unique_lock lock(mutex_);
    asked_ = number;
    while (!drawn_ && !failure_) {
      given_.wait_for(lock, std::chrono::milliseconds(20));
      progress.check();
    }
    if (failure_) std::rethrow_exception(failure_);
    return *std::exchange(drawn_, std::nullopt);
  }
  /// By the window: which picture the job waits for.
  std::optional<int> asked() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(asked_, std::nullopt);
  }
  void give(const QImage& picture) {
    const std::scoped_lock lock(mutex_);
    drawn_ = picture;
    given_.notify_one();
  }
  void give(std::exception_ptr failure) {
    const std::scoped_lock lock(mutex_);
    failure_ = std::move(failure);
    given_.notify_one();
  }

private:
  std::mutex mutex_; // of all below
  std::condition_variable given_;
  std::optional<int> asked_;
  std::optional<QImage> drawn_;
  std::exception_ptr failure_;
};

TurntableFlow::TurntableFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.add({.id = "save_turntable",
                      .text = tr("Save Turntable…"),
                      .help = tr("Writes a movie of the plant, as the view shows it, turning once "
                                 "about its pivot"),
                      .menu = "file/export"},
                     [this] { choose(); });
  drawing_.setInterval(1);
  connect(&drawing_, &QTimer::timeout, this, &TurntableFlow::drawAsked);
  connect(&parts_.jobs, &JobSlot::finished, this, [this] {
    drawing_.stop();
    turntable_.reset();
    frames_.reset();
  });
  refresh();
}

TurntableFlow::~TurntableFlow() = default;

void TurntableFlow::setEnabled(bool isEnabled) {
  isEnabled_ = isEnabled;
  refresh();
}

void TurntableFlow::setPlantShown(bool isShown) {
  isShown_ = isShown;
  refresh();
}

void TurntableFlow::refresh() {
  parts_.actions["save_turntable"]->setEnabled(isEnabled_ && isShown_);
}

void TurntableFlow::choose() {
  parts_.jobs.requireIdle();
  QDialog how(&parts_.window);
  how.setObjectName("turntable");
  how.setWindowTitle(tr("Turntable"));
  setManualPlace(how, QStringLiteral("files.md#pictures-and-movies"));
  const auto number = [&](const char* name, int least, int most, int value, const QString& unit) {
    auto* box = new QSpinBox(&how);
    box->setObjectName(name);
    box->setRange(least, most);
    box->setValue(value);
    box->setSuffix(unit);
    return box;
  };
  auto* width = number("turntable_width", 160, 3840, width_, tr(" pixels"));
  auto* seconds = number("turntable_seconds", TurntableOptions::leastSeconds,
                         TurntableOptions::mostSeconds, seconds_, tr(" s"));
  auto* form = new QFormLayout;
  form->addRow(tr("Width"), width);
  form->addRow(tr("One turn takes"), seconds);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, &how);
  buttons->addButton(tr("Choose File"), QDialogButtonBox::AcceptRole)->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, &how, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &how, &QDialog::reject);
  auto* column = new QVBoxLayout(&how);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addLayout(form);
  column->addWidget(buttons);
  if (how.exec() != QDialog::Accepted) return;
  width_ = width->value();
  seconds_ = seconds->value();
  QFileDialog dialog(&parts_.window, tr("Save the turntable"), {}, tr("Animated PNG (*.png)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("png");
  proposeBeside(dialog, parts_.document, ".turntable.png");
  if (dialog.exec() == QDialog::Accepted) write(dialog.selectedFiles().front(), width_, seconds_);
}

void TurntableFlow::write(const QString& path, int width, int seconds) {
  if (QFileInfo(path).suffix().toLower() != "png")
    throw Error(tr("%1: movies are written as animated PNG: choose a name that ends in .png")
                    .arg(path)
                    .toStdString());
  parts_.jobs.requireIdle();
  requireWritable(toPath(path));
  const double pixelRatio = static_cast<double>(width) / parts_.view.width();
  const TurntableOptions options{.size = (QSizeF(parts_.view.size()) * pixelRatio).toSize(),
                                 .pixelRatio = pixelRatio,
                                 .seconds = seconds};
  turntable_ = parts_.view.turntable(options);
  frames_ = std::make_shared<TurntableFrames>();
  drawing_.start();
  parts_.jobs.start(
      tr("Writing %1").arg(QFileInfo(path).fileName()),
      [frames = frames_, path, count = options.frames()](const Progress& progress) {
        writeAtomically(toPath(path), [&](std::ostream& out) {
          AnimatedPng movie(out, static_cast<std::uint32_t>(count), TurntableOptions::perSecond);
          for (int i = 0; i < count; ++i) {
            movie.add(frames->take(i, progress));
            progress.update(static_cast<double>(i + 1) / count);
          }
        });
        return QFileInfo(path).size();
      },
      [this, path, options](qint64 bytes) {
        emit reported({.text = tr("Wrote %1: %2 pictures, %3 MB")
                                   .arg(QFileInfo(path).fileName())
                                   .arg(options.frames())
                                   .arg(static_cast<double>(bytes) * 1e-6, 0, 'f', 1)});
      });
}

void TurntableFlow::drawAsked() {
  if (!frames_) return;
  const std::optional<int> asked = frames_->asked();
  if (!asked) return;
  try {
    frames_->give(turntable_->frame(*asked));
  } catch (const Error&) { // to the job, which reports it
    frames_->give(std::current_exception());
  }
}

} // namespace espalier
