#include "ui/document/typed_number.h"

#include <QLocale>

#include <cmath>

namespace espalier {

std::optional<double> typedNumber(QString text) {
  text.removeIf([](QChar letter) { return letter.isSpace(); });
  text.replace(',', '.').replace(QChar(0x2212), '-'); // as it is written
  bool isNumber = false;
  const double number = QLocale::c().toDouble(text, &isNumber);
  return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

} // namespace espalier
