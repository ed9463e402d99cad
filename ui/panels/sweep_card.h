#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QString>

#include <vector>

namespace espalier {

/// One of the numbers a state is judged by.
struct SweepScore {
  QString name;
  QString text;
  bool isBest = false; // of all in the strip
  QString tip = {};    // what it means
};

/// What came of one value of a parameter.
struct SweepItem {
  QString of;    // the parameter: "Contract: Radius"
  QString label; // the value as people read it: "12.5 mm"
  QImage picture;
  std::vector<SweepScore> scores;
  QString failure;        // why there is no picture; empty: there is one, or it is to come
  bool isPending = false; // it is to come
  bool isCurrent = false; // the value in use
};

/// A picture of one value of a parameter, with its scores below it, or beside it where there is
/// room. Scores come first, the picture has what is left.
class SweepCard : public QAbstractButton {
  Q_OBJECT

public:
  static constexpr int side = 144; // of the picture at least [px], if there is room

  explicit SweepCard(QWidget* parent = nullptr);

  void setItem(const SweepItem& item);
  [[nodiscard]] const SweepItem& item() const { return item_; }
  /// Room for so many scores: the cards of a strip are alike.
  void setRows(std::size_t rows);
  [[nodiscard]] QSize pictureSize() const { return pictureBox().size(); }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

signals:
  void hovered(bool isInside); // by the pointer, or reached by a key
  void resized();              // the picture has other room

protected:
  bool event(QEvent* event) override; // tips of the scores
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  [[nodiscard]] QSize sizeWith(int pictureHeight) const;
  [[nodiscard]] bool isWide() const;
  [[nodiscard]] QRect pictureBox() const;
  [[nodiscard]] QRect headBox() const;
  [[nodiscard]] QRect scoreBox() const;
  void paintPicture(QPainter& painter, const QRect& box) const;
  void paintScores(QPainter& painter, const QRect& box) const;

  SweepItem item_;
  std::size_t rows_ = 0;
};

} // namespace espalier
