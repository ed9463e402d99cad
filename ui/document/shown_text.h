#pragma once

#include <QCoreApplication>
#include <QString>

#include <string>

namespace espalier {

/// English text that core marks with Shown::tr(), in the language of the window.
[[nodiscard]] inline QString shownText(const std::string& english) {
  return QCoreApplication::translate("espalier::Shown", english.c_str());
}

} // namespace espalier
