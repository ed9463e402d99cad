#include "app/window/files/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace espalier {
namespace {

const QString key = QStringLiteral("recent_files");

} // namespace

RecentFiles::RecentFiles(QSettings& settings, QObject* parent)
    : QObject(parent), settings_(settings) {}

QStringList RecentFiles::paths() const {
  QStringList result;
  for (const QString& path : settings_.value(key).toStringList())
    if (QFileInfo::exists(path)) result.append(path);
  return result;
}

void RecentFiles::add(const QString& path) {
  const QString whole = QFileInfo(path).absoluteFilePath();
  QStringList paths = settings_.value(key).toStringList();
  paths.removeAll(whole);
  paths.prepend(whole);
  settings_.setValue(key, QStringList(paths.mid(0, most)));
  emit changed();
}

void RecentFiles::clear() {
  settings_.remove(key);
  emit changed();
}

} // namespace espalier
