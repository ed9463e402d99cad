#pragma once

#include "core/skeleton/review_coverage.h"

#include <QWidget>

namespace espalier {

/// How much is reviewed, doubtful and to do, as parts of a bar. Doubt is hatched as well as
/// colored.
class CoverageBar : public QWidget {
  Q_OBJECT

public:
  explicit CoverageBar(QWidget* parent = nullptr);

  void setCoverage(const ReviewCoverage& coverage);
  [[nodiscard]] const ReviewCoverage& coverage() const { return coverage_; }

  /// A sample of the color of a state.
  [[nodiscard]] QPixmap sample(ReviewState state) const;

  [[nodiscard]] QSize sizeHint() const override { return {120, 12}; }

signals:
  void colorsChanged(); // with the theme: samples are to be taken anew

protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void fill(QPainter& painter, const QRectF& part, ReviewState state) const;

  ReviewCoverage coverage_;
};

} // namespace espalier
