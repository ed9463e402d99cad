#pragma once

#include <QFrame>
#include <QPointer>

class QLabel;
class QPushButton;

namespace espalier {

/// A short hint over the view of its parent, a window, beside the widget that it speaks of.
class TourHint : public QFrame {
  Q_OBJECT

public:
  explicit TourHint(QWidget* parent); // in no layout of it

  /// @param beside  that is meant; at the right of the view if it is not shown
  /// @param next    what the button says that goes on
  void showText(const QString& title, const QString& text, const QString& next, QWidget* beside);
  [[nodiscard]] QString text() const;

signals:
  void nextAsked();
  void leaveAsked();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override; // resized: the parent, or its view

private:
  void place();

  QLabel* title_;
  QLabel* text_;
  QPushButton* next_;
  QPointer<QWidget> beside_;
};

} // namespace espalier
