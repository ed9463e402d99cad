#include "ui/panels/status_line.h"

#include "ui/document/shown_text.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/time_left.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace espalier {

StatusLine::StatusLine(QWidget* parent)
    : QWidget(parent), text_(new ElidedLabel(this)), job_(new QWidget(this)),
      jobName_(new QLabel(job_)), bar_(new QProgressBar(job_)), timeLeft_(new QLabel(job_)),
      counts_(new QLabel(this)) {
  setObjectName("status_line");
  text_->setObjectName("hint");
  counts_->setObjectName("counts");
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedSize(140, 6);
  bar_->setAccessibleName(tr("Progress"));
  timeLeft_->setFixedWidth(timeLeft_->fontMetrics().horizontalAdvance(describeTimeLeft(59 * 60)));
  auto* cancel = new QPushButton(tr("Cancel"), job_);
  cancel->setObjectName("cancel_job");
  auto* jobRow = new QHBoxLayout(job_);
  jobRow->setContentsMargins(0, 0, 0, 0);
  jobRow->setSpacing(8);
  for (QWidget* widget : {static_cast<QWidget*>(jobName_), static_cast<QWidget*>(bar_),
                          static_cast<QWidget*>(timeLeft_), static_cast<QWidget*>(cancel)})
    jobRow->addWidget(widget);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 2, 12, 2);
  row->setSpacing(24);
  row->addWidget(text_, 1);
  row->addWidget(counts_);
  row->addWidget(job_); // at the end, so that Cancel does not move with the text
  setFixedHeight(32);
  job_->hide();
  noteEnds_.setSingleShot(true);
  noteEnds_.setInterval(5000);
  connect(&noteEnds_, &QTimer::timeout, this, [this] { showNote({}); });
  connect(cancel, &QPushButton::clicked, this, &StatusLine::cancelRequested);
}

void StatusLine::setHint(const QString& text) {
  constexpr int glance = 1500; // [ms]
  const bool isRead =
      noteEnds_.isActive() && noteEnds_.interval() - noteEnds_.remainingTime() > glance;
  if (text != hint_ && isRead) note_.clear(); // the pointer is at something else by now
  hint_ = text;
  refreshText();
}

void StatusLine::showNote(const QString& text) {
  note_ = text;
  if (!text.isEmpty()) noteEnds_.start();
  refreshText();
}

void StatusLine::setCounts(const QString& text) {
  counts_->setText(text);
}

QString StatusLine::shownText() const {
  return text_->text();
}

QString StatusLine::counts() const {
  return counts_->text();
}

void StatusLine::showJob(const QString& name) {
  jobName_->setText(name);
  timeLeft_->clear();
  bar_->setValue(0);
  elapsed_.start();
  job_->show();
}

void StatusLine::showProgress(double fraction, const QString& stage) {
  bar_->setValue(static_cast<int>(1000 * fraction));
  if (!stage.isEmpty()) jobName_->setText(espalier::shownText(stage.toStdString()));
  const double seconds = static_cast<double>(elapsed_.elapsed()) / 1000;
  timeLeft_->setText(describeTimeLeft(secondsLeft(seconds, fraction)));
}

void StatusLine::hideJob() {
  job_->hide();
}

void StatusLine::refreshText() {
  const QString text = note_.isEmpty() ? hint_ : note_;
  text_->setText(text);
  text_->setToolTip(text); // in full where the window is narrow
}

} // namespace espalier
