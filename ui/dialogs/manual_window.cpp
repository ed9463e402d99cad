#include "ui/dialogs/manual_window.h"

#include "core/pipeline/registry.h"
#include "ui/document/shown_text.h"

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QImage>
#include <QListWidget>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>

#include <algorithm>

namespace espalier {
namespace {

QString withMethods(QString manual) {
  for (const Step& step : pipelineSteps()) {
    QStringList rows;
    for (const Method& method : step.methods)
      if (!method.inManual.empty())
        rows.append(QStringLiteral("| %1 | %2 | %3 |")
                        .arg(shownText(method.label), shownText(method.inManual),
                             QString::fromStdString(method.source)));
    manual.replace(QStringLiteral("{methods %1}").arg(QString::fromStdString(step.name)),
                   rows.join('\n'));
  }
  return manual;
}

} // namespace

ManualWindow::ManualWindow(const QString& file, QWidget* parent)
    : QDialog(parent), headings_(new QListWidget(this)), text_(new QTextBrowser(this)) {
  setObjectName("manual_window");
  setWindowTitle(tr("Manual"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(1000, 680);
  text_->setSearchPaths({QFileInfo(file).path()});
  text_->setOpenExternalLinks(true);
  text_->setFrameShape(QFrame::NoFrame);
  text_->document()->setDocumentMargin(16);
  headings_->setFrameShape(QFrame::NoFrame);
  headings_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  headings_->setWordWrap(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 8, 8, 8);
  row->setSpacing(8);
  row->addWidget(headings_);
  row->addWidget(text_, 1);
  QFile source(file);
  const bool isThere = source.open(QIODevice::ReadOnly);
  Q_ASSERT(isThere);
  if (isThere) text_->setMarkdown(withMethods(QString::fromUtf8(source.readAll())));
  fitPictures();
  listHeadings();
  constexpr int widest = 280; // [px]; longer headings are wrapped
  const int beside = headings_->verticalScrollBar()->sizeHint().width() + 16;
  headings_->setFixedWidth(std::min(widest, headings_->sizeHintForColumn(0) + beside));
  connect(headings_, &QListWidget::currentRowChanged, this, &ManualWindow::goTo);
}

void ManualWindow::fitPictures() {
  constexpr int widest = 620; // [px]
  for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      const QTextFragment fragment = part.fragment();
      if (!fragment.charFormat().isImageFormat()) continue;
      QTextImageFormat picture = fragment.charFormat().toImageFormat();
      const QVariant file = text_->loadResource(QTextDocument::ImageResource, picture.name());
      picture.setWidth(std::min(widest, QImage::fromData(file.toByteArray()).width()));
      QTextCursor cursor(text_->document());
      cursor.setPosition(fragment.position());
      cursor.setPosition(fragment.position() + fragment.length(), QTextCursor::KeepAnchor);
      cursor.setCharFormat(picture);
      break; // the parts of this block are others now
    }
  }
}

void ManualWindow::listHeadings() {
  for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0) continue;
    auto* item = new QListWidgetItem(block.text(), headings_);
    item->setData(Qt::UserRole, block.position());
  }
}

void ManualWindow::goTo(int heading) {
  const QListWidgetItem* item = headings_->item(heading);
  if (item == nullptr) return;
  const QTextBlock block = text_->document()->findBlock(item->data(Qt::UserRole).toInt());
  const QRectF place = text_->document()->documentLayout()->blockBoundingRect(block);
  text_->verticalScrollBar()->setValue(static_cast<int>(place.top()) - 8);
}

} // namespace espalier
