#include "app/report/pdf_pages.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QMarginsF>
#include <QPageLayout>
#include <QPageSize>

namespace espalier {
namespace {

constexpr double foot = 28;
constexpr int resolution = 96; // so that a unit of the painter is a CSS pixel

constexpr int wrapped = Qt::TextWordWrap;

} // namespace

PdfPages::PdfPages(const QString& title) : title_(title) {
  buffer_.open(QIODevice::WriteOnly);
  writer_ = std::make_unique<QPdfWriter>(&buffer_);
  writer_->setResolution(resolution);
  writer_->setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait,
                                     QMarginsF(15, 15, 15, 12), QPageLayout::Millimeter));
  writer_->setTitle(title);
  writer_->setCreator(QStringLiteral("Espalier"));
  painter_ = std::make_unique<QPainter>(writer_.get());
  painter_->setRenderHint(QPainter::SmoothPixmapTransform);
}

double PdfPages::width() const {
  return writer_->width();
}

double PdfPages::height() const {
  return writer_->height() - foot;
}

void PdfPages::need(double height) {
  if (y_ + height <= this->height() || y_ == 0) return;
  drawFoot();
  writer_->newPage();
  ++page_;
  y_ = 0;
}

QFont PdfPages::fontOf(const PdfText& look) const {
  QFont font = look.isCode ? QFontDatabase::systemFont(QFontDatabase::FixedFont)
                           : QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  font.setHintingPreference(QFont::PreferNoHinting); // glyphs stand where paper has them
  font.setPointSizeF(look.size * 72 / resolution);
  font.setBold(look.isBold);
  return font;
}

double PdfPages::heightOf(const QString& text, double width, const PdfText& look) const {
  const QFontMetricsF metrics(fontOf(look), writer_.get());
  return metrics.boundingRect(QRectF(0, 0, width, 1e6), wrapped, text).height();
}

double PdfPages::widthOf(const QString& text, const PdfText& look) const {
  return QFontMetricsF(fontOf(look), writer_.get()).horizontalAdvance(text) + 1;
}

void PdfPages::setLook(const PdfText& look) {
  painter_->setFont(fontOf(look));
  painter_->setPen(look.color);
}

void PdfPages::draw(const QRectF& box, const QString& text, const PdfText& look,
                    Qt::Alignment alignment) {
  setLook(look);
  painter_->drawText(box, wrapped | static_cast<int>(alignment), text);
}

void PdfPages::drawFoot() {
  const PdfText look{.size = 9, .color = QColor(0x5b, 0x63, 0x5f)};
  const QRectF box(0, height() + foot - 14, width(), 14);
  draw(box, title_, look);
  draw(box, QString::number(page_), look, Qt::AlignRight | Qt::AlignTop);
}

QByteArray PdfPages::bytes() {
  drawFoot();
  painter_->end();
  return buffer_.data();
}

} // namespace espalier
