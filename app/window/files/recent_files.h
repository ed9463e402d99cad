#pragma once

#include <QObject>
#include <QStringList>

class QSettings;

namespace espalier {

/// The files opened or saved lately, newest first, kept in the settings.
class RecentFiles : public QObject {
  Q_OBJECT

public:
  static constexpr qsizetype most = 10;

  explicit RecentFiles(QSettings& settings, QObject* parent = nullptr);

  /// Those that still exist.
  [[nodiscard]] QStringList paths() const;
  void add(const QString& path);
  void clear();

signals:
  void changed();

private:
  QSettings& settings_;
};

} // namespace espalier
