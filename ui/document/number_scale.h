#pragma once

#include <QString>

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {

/// The greatest of 1, 2 or 5 times a power of ten that is not above `most`; pre: most > 0
[[nodiscard]] inline double roundStep(double most) {
  const double power = std::pow(10, std::floor(std::log10(most) + 1e-9));
  const double rest = most / power * (1 + 1e-9);
  return (rest >= 5 ? 5 : rest >= 2 ? 2 : 1) * power;
}

/// The multiples of `step` within a range, for the numbers of an axis; pre: step > 0
[[nodiscard]] inline std::vector<double> multiplesOf(double step, double from, double to) {
  std::vector<double> numbers;
  const double slack = 1e-9 * step;
  const double first = std::ceil((from - slack) / step);
  for (double count = first; count * step <= to + slack; ++count)
    numbers.push_back(count * step);
  return numbers;
}

/// A number with its thousands parted and the sign of mathematics, as everywhere in the window:
/// "1 250.5", "−3". pre: decimals >= 0
[[nodiscard]] inline QString numberText(double value, int decimals) {
  QString text = QString::number(std::abs(value), 'f', decimals);
  const qsizetype end = text.contains('.') ? text.indexOf('.') : text.size();
  for (qsizetype at = end - 3; at > 0; at -= 3)
    text.insert(at, QChar(0x202f));
  return value < 0 ? QChar(0x2212) + text : text;
}

/// A number with as many digits as a step between such numbers calls for: "1 250", "0.05".
[[nodiscard]] inline QString numberAtStep(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
  return numberText(std::abs(value) < 1e-9 * step ? 0 : value, decimals); // no "−0"
}

} // namespace espalier
