#pragma once

#include <QElapsedTimer>
#include <QTimer>
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
  /// Shows `text` in place of the hint for as long as it takes to read it.
  void showNote(const QString& text);
  void setCounts(const QString& text);     // "147 989 pts · 1 204 nodes · mm"
  [[nodiscard]] QString shownText() const; // the note or the hint
  [[nodiscard]] QString counts() const;

  void showJob(const QString& name);
  void showProgress(double fraction, const QString& stage);
  void hideJob();

signals:
  void cancelRequested();

private:
  void refreshText();

  QLabel* text_;
  QString hint_;
  QString note_;
  QTimer noteEnds_;
  QWidget* job_;
  QLabel* jobName_;
  QProgressBar* bar_;
  QLabel* timeLeft_;
  QLabel* counts_;
  QElapsedTimer elapsed_;
};

} // namespace espalier
