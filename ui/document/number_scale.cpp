#include "ui/document/number_scale.h"

#include <algorithm>
#include <cmath>

namespace espalier {

double roundStep(double most) {
  const double power = std::pow(10, std::floor(std::log10(most) + 1e-9));
  const double rest = most / power * (1 + 1e-9);
  return (rest >= 5 ? 5 : rest >= 2 ? 2 : 1) * power;
}

std::vector<double> multiplesOf(double step, double from, double to) {
  std::vector<double> numbers;
  const double slack = 1e-9 * step;
  const double first = std::ceil((from - slack) / step);
  for (double count = first; count * step <= to + slack; ++count)
    numbers.push_back(count * step);
  return numbers;
}

QString numberAtStep(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
  return numberText(std::abs(value) < 1e-9 * step ? 0 : value, decimals); // no "-0"
}

QString numberText(double value, int decimals) {
  QString text = QString::number(value, 'f', decimals);
  const qsizetype end = text.contains('.') ? text.indexOf('.') : text.size();
  for (qsizetype at = end - 3; at > (text.startsWith('-') ? 1 : 0); at -= 3)
    text.insert(at, QChar(0x202f));
  return text;
}

} // namespace espalier
