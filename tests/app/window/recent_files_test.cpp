#include "app/window/files/recent_files.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace espalier {
namespace {

struct RecentFilesTest : testing::Test {
  QTemporaryDir folder;
  QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
  RecentFiles recent{settings};

  QString make(const QString& name) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    return file.fileName();
  }
};

TEST_F(RecentFilesTest, ListTheNewestFirstAndOnce) {
  const QString a = make("a.ply");
  const QString b = make("b.ply");
  recent.add(a);
  recent.add(b);
  recent.add(a);
  EXPECT_EQ(recent.paths(), (QStringList{a, b}));
  EXPECT_EQ(RecentFiles(settings).paths(), (QStringList{a, b})) << "they are kept";
}

TEST_F(RecentFilesTest, LeaveOutFilesThatAreGone) {
  recent.add(make("a.ply"));
  QFile::remove(folder.filePath("a.ply"));
  EXPECT_TRUE(recent.paths().isEmpty());
}

TEST_F(RecentFilesTest, KeepAtMostTen) {
  for (int i = 0; i < 15; ++i)
    recent.add(make(QString("%1.ply").arg(i)));
  EXPECT_EQ(recent.paths().size(), RecentFiles::most);
  EXPECT_EQ(recent.paths().front(), folder.filePath("14.ply"));
}

} // namespace
} // namespace espalier
