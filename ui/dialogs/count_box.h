#pragma once

#include <QSpinBox>

#include <cstdint>

namespace espalier {

/// A field for a count of points, whose digits stand in threes as everywhere.
class CountBox : public QSpinBox {
  Q_OBJECT

public:
  explicit CountBox(QWidget* parent = nullptr);

  void setCount(std::uint64_t count); // as much of it as there is room for

protected:
  [[nodiscard]] QString textFromValue(int value) const override;
  [[nodiscard]] int valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& place) const override;
};

} // namespace espalier
