#include "app/window/frame/key_hints.h"

#include "app/window/frame/action_set.h"

#include <QAction>
#include <QRegularExpression>
#include <QStringList>

namespace espalier {

QString withKeys(const QString& hint, const ActionSet& actions) {
  static const QRegularExpression id(QStringLiteral("\\{(\\w+)\\}"));
  const QString between = QStringLiteral("   ");
  QStringList shown;
  for (QString part : hint.split(between)) {
    bool hasKeys = true;
    for (auto found = id.match(part); found.hasMatch() && hasKeys; found = id.match(part)) {
      const QKeySequence keys = actions[found.captured(1)]->shortcut();
      hasKeys = !keys.isEmpty();
      part.replace(found.capturedStart(), found.capturedLength(),
                   keys.toString(QKeySequence::NativeText));
    }
    if (hasKeys) shown.append(part);
  }
  return shown.join(between);
}

} // namespace espalier
