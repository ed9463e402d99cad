#pragma once

#include <QAction>
#include <QString>

namespace espalier::test {

/// The text of an entry of a menu as it is read: without the mark of its letter.
[[nodiscard]] inline QString asRead(const QAction* entry) {
  QStringList parts = entry->text().split("&&");
  for (QString& part : parts)
    part.remove('&');
  return parts.join('&');
}

} // namespace espalier::test
