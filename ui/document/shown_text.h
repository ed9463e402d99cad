#pragma once

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cstddef>
#include <string>

namespace espalier {

/// English text that core marks with Shown::tr(), in the language of the window.
[[nodiscard]] inline QString shownText(const std::string& english) {
  return QCoreApplication::translate("espalier::Shown", english.c_str());
}

/// The same of a name with a count in it, which core marked with "%1" in its place: "order 2", but
/// not "at 1.3 m".
[[nodiscard]] inline QString numberedText(const std::string& english) {
  constexpr const char* digits = "0123456789";
  const std::size_t begin = english.find_first_of(digits);
  if (begin == std::string::npos) return shownText(english);
  const std::size_t end = std::min(english.find_first_not_of(digits, begin), english.size());
  if (end < english.size() && english[end] == '.') return shownText(english);
  return shownText(english.substr(0, begin) + "%1" + english.substr(end))
      .arg(QString::fromStdString(english.substr(begin, end - begin)));
}

} // namespace espalier
