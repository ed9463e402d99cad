#pragma once

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QProgressBar;

namespace espalier {

/// The bottom of the window: what the mouse does now; the job that runs, its progress, time left
/// and Cancel; and how large the plant is.
class StatusLine : public QWidget {
  Q_OBJECT

public:
  explicit StatusLine(QWidget* parent = nullptr);

  void setHint(const QString& text);
  void setCounts(const QString& text); // "147 989 pts · 1 204 nodes · mm"
  [[nodiscard]] QString hint() const;
  [[nodiscard]] QString counts() const;

  void showJob(const QString& name);
  void showProgress(double fraction, const QString& stage);
  void hideJob();

signals:
  void cancelRequested();

private:
  QLabel* hint_;
  QWidget* job_;
  QLabel* jobName_;
  QProgressBar* bar_;
  QLabel* timeLeft_;
  QLabel* counts_;
  QElapsedTimer elapsed_;
};

} // namespace espalier
