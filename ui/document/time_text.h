#pragma once

#include <QDateTime>
#include <QLocale>
#include <QString>

#include <cstdint>

namespace espalier {

/// "26 Nov 2026", as lists and messages have days.
[[nodiscard]] inline QString dayText(const QDate& day) {
  return QLocale().toString(day, QStringLiteral("d MMM yyyy"));
}

/// "17:03", likewise.
[[nodiscard]] inline QString clockText(const QTime& time) {
  return time.toString(QStringLiteral("HH:mm"));
}

/// "26 Nov 2026, 17:03"
[[nodiscard]] inline QString momentText(const QDateTime& time) {
  return dayText(time.date()) + QStringLiteral(", ") + clockText(time.time());
}

[[nodiscard]] inline QString momentText(std::int64_t time) { // [ms] since 1970
  return momentText(QDateTime::fromMSecsSinceEpoch(time));
}

} // namespace espalier
