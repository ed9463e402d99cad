#include "ui/panels/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace espalier {
namespace {

QLabel* makeLabel(const QString& text, const char* role, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", role);
  label->setAlignment(Qt::AlignCenter);
  return label;
}

/// The folder of a file as people write it: "~" for the home folder.
QString folderOf(const QString& path) {
  const QString folder = QDir::toNativeSeparators(QFileInfo(path).path());
  const QString home = QDir::toNativeSeparators(QDir::homePath());
  return folder.startsWith(home) ? "~" + folder.mid(home.size()) : folder;
}

} // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent), icon_(new QLabel(this)), recent_(new QWidget(this)),
      files_(new QVBoxLayout(recent_)) {
  setObjectName("start_page");
  setAttribute(Qt::WA_StyledBackground); // a plain widget paints no background of a style sheet
  icon_->setAlignment(Qt::AlignCenter);
  auto* open = new QPushButton(tr("Open…"), this);
  open->setObjectName("open_button");
  open->setProperty("role", "primary");
  open->setCursor(Qt::PointingHandCursor);
  files_->setContentsMargins(0, 0, 0, 0);
  files_->setSpacing(0);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(8);
  column->addStretch(3);
  column->addWidget(icon_);
  column->addSpacing(8);
  column->addWidget(makeLabel(tr("Open a scan, or drop one here"), "headline", this));
  column->addWidget(
      makeLabel(tr("PLY, LAS, PCD, XYZ and their kin; a skeleton as MTG opens over its scan"),
                "quiet", this));
  column->addSpacing(12);
  column->addWidget(open, 0, Qt::AlignCenter);
  column->addSpacing(28);
  column->addWidget(recent_, 0, Qt::AlignCenter);
  column->addStretch(4);
  connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
}

void StartPage::setIcon(const QIcon& icon) {
  icon_->setPixmap(icon.pixmap(QSize(96, 96), devicePixelRatioF()));
}

void StartPage::setRecentFiles(const QStringList& paths) {
  while (QLayoutItem* item = files_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  recent_->setVisible(!paths.isEmpty());
  if (paths.isEmpty()) return;
  files_->addWidget(makeLabel(tr("Recent"), "section", recent_));
  constexpr qsizetype most = 6;
  for (const QString& path : paths.mid(0, most)) {
    auto* file = new QPushButton(
        QStringLiteral("%1    %2").arg(QFileInfo(path).fileName(), folderOf(path)), recent_);
    file->setProperty("role", "link");
    file->setFlat(true);
    file->setCursor(Qt::PointingHandCursor);
    file->setToolTip(QDir::toNativeSeparators(path));
    files_->addWidget(file, 0, Qt::AlignCenter);
    connect(file, &QPushButton::clicked, this, [this, path] { emit fileChosen(path); });
  }
}

} // namespace espalier
