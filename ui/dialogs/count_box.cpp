#include "ui/dialogs/count_box.h"

#include "ui/document/length_unit.h"

#include <algorithm>
#include <limits>

namespace espalier {
namespace {

constexpr int largestCount = std::numeric_limits<int>::max();

/// Without what stands between digits.
QString digitsOf(const QString& text) {
  QString digits;
  for (const QChar each : text)
    if (each.isDigit()) digits.append(each);
  return digits;
}

} // namespace

CountBox::CountBox(QWidget* parent) : QSpinBox(parent) {
  setRange(1, largestCount);
  setSingleStep(1'000'000);
}

void CountBox::setCount(std::uint64_t count) {
  setValue(static_cast<int>(std::min<std::uint64_t>(count, largestCount)));
}

QString CountBox::textFromValue(int value) const {
  return formatCount(static_cast<std::size_t>(value));
}

int CountBox::valueFromText(const QString& text) const {
  return digitsOf(text).toInt();
}

QValidator::State CountBox::validate(QString& text, int& /*place*/) const {
  const bool isOther = std::ranges::any_of(text, [](QChar each) {
    return !each.isDigit() && !each.isSpace() && each != ',' && each != '.';
  });
  if (isOther) return QValidator::Invalid;
  bool isNumber = false;
  const int value = digitsOf(text).toInt(&isNumber);
  return isNumber && value >= minimum() ? QValidator::Acceptable : QValidator::Intermediate;
}

} // namespace espalier
