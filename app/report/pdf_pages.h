#pragma once

#include <QBuffer>
#include <QColor>
#include <QFont>
#include <QPainter>
#include <QPdfWriter>
#include <QRectF>
#include <QString>

#include <memory>

namespace espalier {

/// What text on a page looks like.
struct PdfText {
  double size = 11; // [CSS pixels], as all lengths here
  bool isBold = false;
  QColor color = Qt::black;
  bool isCode = false;
};

/// Pages of A4 that are filled from top to bottom.
class PdfPages {
public:
  explicit PdfPages(const QString& title);

  [[nodiscard]] double width() const;  // of what can be written on
  [[nodiscard]] double height() const; //
  [[nodiscard]] double y() const { return y_; }
  [[nodiscard]] int page() const { return page_; } // from 1 on
  [[nodiscard]] QPainter& painter() { return *painter_; }

  /// Goes to the next page unless so much is left; pre: nothing is higher than a page
  void need(double height);
  void advance(double by) { y_ += by; }

  [[nodiscard]] double heightOf(const QString& text, double width, const PdfText& look) const;
  [[nodiscard]] double widthOf(const QString& text, const PdfText& look) const;
  /// Wrapped within the box.
  void draw(const QRectF& box, const QString& text, const PdfText& look,
            Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignTop);

  void setLook(const PdfText& look); // for who paints by himself

  /// Ends the last page. Nothing can be added any more.
  [[nodiscard]] QByteArray bytes();

private:
  void drawFoot();
  [[nodiscard]] QFont fontOf(const PdfText& look) const;

  QString title_;
  QBuffer buffer_;
  std::unique_ptr<QPdfWriter> writer_;
  std::unique_ptr<QPainter> painter_;
  double y_ = 0;
  int page_ = 1;
};

} // namespace espalier
