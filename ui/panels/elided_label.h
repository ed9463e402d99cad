#pragma once

#include <QLabel>

namespace espalier {

/// A line of plain text that ends in "…" where there is no room for all of it. It asks for no
/// width: what it says must stand elsewhere, too, as in its tip. A tip that says the same is shown
/// only where the line is cut.
class ElidedLabel : public QLabel {
  Q_OBJECT

public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

} // namespace espalier
