#include "ui/panels/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace espalier {
namespace {

QLabel* startLabel(const QString& text, const char* role) {
  auto* label = new QLabel(text);
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
    : QScrollArea(parent), icon_(new QLabel), recent_(new QWidget),
      files_(new QVBoxLayout(recent_)), work_(new QWidget), sessions_(new QVBoxLayout(work_)) {
  setObjectName("start_page");
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  auto* page = new QWidget;
  page->setObjectName("start_content");
  page->setAttribute(Qt::WA_StyledBackground); // a plain widget paints none of a style sheet
  setWidget(page);
  icon_->setAlignment(Qt::AlignCenter);
  auto* open = new QPushButton(tr("Open…"));
  open->setObjectName("open_button");
  open->setProperty("role", "primary");
  open->setCursor(Qt::PointingHandCursor);
  auto* sample = new QPushButton(tr("Try a sample plant"));
  sample->setObjectName("sample_button");
  sample->setProperty("role", "link");
  sample->setFlat(true);
  sample->setCursor(Qt::PointingHandCursor);
  for (QVBoxLayout* list : {files_, sessions_}) {
    list->setContentsMargins(0, 0, 0, 0);
    list->setSpacing(0);
  }
  work_->hide();
  auto* column = new QVBoxLayout(page);
  column->setSpacing(8);
  column->addStretch(3);
  column->addWidget(icon_);
  column->addSpacing(8);
  column->addWidget(startLabel(tr("Open a scan, or drop one here"), "headline"));
  column->addWidget(startLabel(
      tr("PLY, LAS, LAZ, E57, PCD, XYZ and their kin; a skeleton as MTG opens over its scan"),
      "quiet"));
  column->addSpacing(12);
  column->addWidget(open, 0, Qt::AlignCenter);
  column->addWidget(sample, 0, Qt::AlignCenter);
  column->addSpacing(28);
  column->addWidget(work_, 0, Qt::AlignCenter);
  column->addWidget(recent_, 0, Qt::AlignCenter);
  column->addStretch(4);
  connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
  connect(sample, &QPushButton::clicked, this, &StartPage::sampleRequested);
}

void StartPage::setIcon(const QIcon& icon) {
  icon_->setPixmap(icon.pixmap(QSize(96, 96), devicePixelRatioF()));
}

void StartPage::setRecentFiles(const QStringList& paths) {
  constexpr qsizetype most = 6;
  QStringList texts;
  for (const QString& path : paths.mid(0, most))
    texts.append(QStringLiteral("%1    %2").arg(QFileInfo(path).fileName(), folderOf(path)));
  fill(*recent_, *files_, tr("Recent"), texts, paths);
}

void StartPage::setSessions(const QStringList& texts, const QStringList& paths) {
  constexpr qsizetype most = 4;
  fill(*work_, *sessions_, tr("Not saved yet"), texts.mid(0, most), paths);
}

int StartPage::covered(const QRect& part) const {
  int covered = 0;
  for (const QWidget* text : widget()->findChildren<QWidget*>()) {
    if (!text->isVisible() || text == recent_ || text == work_) continue;
    const QRect shared = part & QRect(text->mapTo(this, QPoint()), text->size());
    covered += shared.width() * shared.height();
  }
  return covered;
}

void StartPage::fill(QWidget& box, QVBoxLayout& list, const QString& title,
                     const QStringList& texts, const QStringList& paths) {
  while (QLayoutItem* item = list.takeAt(0)) {
    delete item->widget();
    delete item;
  }
  box.setVisible(!texts.isEmpty());
  if (texts.isEmpty()) return;
  list.addWidget(startLabel(title, "section"));
  for (qsizetype i = 0; i < texts.size(); ++i) {
    auto* file = new QPushButton(texts[i], &box);
    file->setProperty("role", "link");
    file->setFlat(true);
    file->setCursor(Qt::PointingHandCursor);
    file->setToolTip(QDir::toNativeSeparators(paths[i]));
    list.addWidget(file, 0, Qt::AlignCenter);
    connect(file, &QPushButton::clicked, this, [this, path = paths[i]] { emit fileChosen(path); });
  }
}

} // namespace espalier
