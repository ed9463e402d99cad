#pragma once

#include <QDateTime>
#include <QList>
#include <QString>

class QSettings;

namespace espalier {

/// Work that never got a name, left by a window before.
struct Session {
  QString path;
  QString name;      // of the plant
  QString scan = {}; // path of its file; empty if there is none
  QString file = {}; // the same of its structure
  int edits = 0;
  QDateTime last; // edit
};

/// The folder of projects that have no name yet: each window that edits writes one there.
class Sessions {
public:
  explicit Sessions(const QSettings& settings);

  [[nodiscard]] bool contains(const QString& path) const;
  [[nodiscard]] QString newPath() const; // a name that is free; makes the folder
  /// Those that no window works on, the newest first. Files that cannot be read are passed over.
  [[nodiscard]] QList<Session> waiting() const;
  static void remove(const QString& path); // with what lies beside it

private:
  QString folder_;
};

/// "scan in puu1, 14 edits, yesterday 17:03"
[[nodiscard]] QString describe(const Session& session, const QDateTime& now);

} // namespace espalier
