#include "ui/dialogs/manual_window.h"

#include "ui/dialogs/manual_chapters.h"
#include "ui/document/manual_place.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QHBoxLayout>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QShortcut>
#include <QStackedWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QToolButton>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {
namespace {

constexpr int sideWidth = 280; // [px]; longer headings are cut, and whole in their tips
constexpr int placeRole = Qt::UserRole;

/// Has its chapters and pictures from the manual.
class ManualText : public QTextBrowser {
public:
  using QTextBrowser::QTextBrowser;

  QVariant loadResource(int type, const QUrl& name) override {
    if (type == QTextDocument::ImageResource) return manualPicture(name.fileName());
    for (const ManualChapter& chapter : manualChapters())
      if (chapter.file == name.fileName()) return chapter.text.toUtf8();
    return {};
  }
};

/// What stands below a heading, up to the next one, without marks of Markdown.
struct Section {
  QString place;
  QString title;
  QString chapter;
  QString text;
};

std::vector<Section> sectionsOf(const ManualChapter& chapter) {
  QTextDocument document;
  document.setMarkdown(chapter.text);
  std::vector<Section> sections;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    const int level = block.blockFormat().headingLevel();
    if (level == 1)
      sections.push_back({chapter.file, block.text(), chapter.title, {}});
    else if (level > 1)
      sections.push_back(
          {chapter.file + '#' + manualAnchor(block.text()), block.text(), chapter.title, {}});
    else if (!sections.empty())
      sections.back().text += block.text() + '\n';
  }
  return sections;
}

const std::vector<Section>& allSections() {
  static const std::vector<Section> all = [] {
    std::vector<Section> sections;
    for (const ManualChapter& chapter : manualChapters())
      for (Section& section : sectionsOf(chapter))
        sections.push_back(std::move(section));
    return sections;
  }();
  return all;
}

bool holdsAll(const QString& text, const QStringList& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

/// The text around the first word that is found in it.
QString excerptOf(const QString& text, const QStringList& words) {
  constexpr qsizetype before = 24;
  constexpr qsizetype length = 90;
  qsizetype at = -1;
  for (const QString& word : words)
    if (const qsizetype its = text.indexOf(word, 0, Qt::CaseInsensitive); at < 0) at = its;
  const qsizetype from = std::max<qsizetype>(0, at - before);
  return (from > 0 ? QStringLiteral("…") : QString()) + text.mid(from, length).simplified();
}

QTreeWidgetItem* itemNamed(const QTreeWidget& tree, const QString& place) {
  for (QTreeWidgetItemIterator at(const_cast<QTreeWidget*>(&tree)); *at != nullptr; ++at)
    if ((*at)->data(0, placeRole).toString() == place) return *at;
  return nullptr;
}

} // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QDialog(parent), search_(new QLineEdit(this)), lists_(new QStackedWidget(this)),
      chapters_(new QTreeWidget(lists_)), found_(new QListWidget(lists_)),
      text_(new ManualText(this)) {
  setObjectName("manual_window");
  setWindowTitle(tr("Manual"));
  setAttribute(Qt::WA_DeleteOnClose);
  setManualPlace(*this, QStringLiteral("README.md"));
  resize(1040, 700);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 8, 8, 8);
  row->setSpacing(8);
  row->addWidget(makeSide());
  row->addWidget(makePage(), 1);
  listChapters();
  connect(chapters_, &QTreeWidget::itemClicked, this,
          [this](const QTreeWidgetItem* item) { goTo(item->data(0, placeRole).toString()); });
  connect(chapters_, &QTreeWidget::itemActivated, this,
          [this](const QTreeWidgetItem* item) { goTo(item->data(0, placeRole).toString()); });
  connect(found_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr) goTo(item->data(placeRole).toString());
  });
  connect(search_, &QLineEdit::textChanged, this, &ManualWindow::find);
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    if (found_->count() > 0) found_->setCurrentRow((found_->currentRow() + 1) % found_->count());
  });
  connect(text_, &QTextBrowser::sourceChanged, this, &ManualWindow::takeChapter);
  connect(text_, &QTextBrowser::anchorClicked, this, &ManualWindow::follow);
  text_->setSource(QUrl(manualChapters().front().file), QTextDocument::MarkdownResource);
}

QWidget* ManualWindow::makeSide() {
  auto* side = new QWidget(this);
  side->setFixedWidth(sideWidth);
  search_->setObjectName("manual_search");
  search_->setPlaceholderText(tr("Search"));
  search_->setClearButtonEnabled(true);
  chapters_->setObjectName("manual_chapters");
  chapters_->setHeaderHidden(true);
  chapters_->setFrameShape(QFrame::NoFrame);
  chapters_->setIndentation(14);
  chapters_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  found_->setObjectName("manual_found");
  found_->setFrameShape(QFrame::NoFrame);
  found_->setWordWrap(true);
  found_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  lists_->addWidget(chapters_);
  lists_->addWidget(found_);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(search_);
  column->addWidget(lists_, 1);
  connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, search_,
          qOverload<>(&QWidget::setFocus));
  return side;
}

QWidget* ManualWindow::makePage() {
  auto* page = new QWidget(this);
  auto* bar = new QHBoxLayout;
  bar->setSpacing(4);
  const auto addButton = [&](const char* name, const QString& text, const QKeySequence& keys) {
    auto* button = new QToolButton(page);
    button->setObjectName(name);
    button->setAutoRaise(true);
    button->setText(text);
    button->setShortcut(keys);
    button->setToolTip(keys.toString(QKeySequence::NativeText));
    button->setEnabled(false);
    bar->addWidget(button);
    return button;
  };
  auto* back = addButton("manual_back", tr("◂ Back"), Qt::ALT | Qt::Key_Left);
  auto* forward = addButton("manual_forward", tr("Forward ▸"), Qt::ALT | Qt::Key_Right);
  bar->addStretch(1);
  connect(back, &QToolButton::clicked, text_, &QTextBrowser::backward);
  connect(forward, &QToolButton::clicked, text_, &QTextBrowser::forward);
  connect(text_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(text_, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
  text_->setOpenLinks(false);
  text_->setFrameShape(QFrame::NoFrame);
  text_->document()->setDocumentMargin(16);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addLayout(bar);
  column->addWidget(text_, 1);
  return page;
}

void ManualWindow::listChapters() {
  for (const ManualChapter& chapter : manualChapters()) {
    auto* item = new QTreeWidgetItem(chapters_, {chapter.title});
    item->setData(0, placeRole, chapter.file);
    item->setToolTip(0, chapter.title);
  }
  for (const Section& section : allSections()) {
    if (!section.place.contains('#')) continue;
    auto* chapter = itemNamed(*chapters_, section.place.section('#', 0, 0));
    auto* item = new QTreeWidgetItem(chapter, {section.title});
    item->setData(0, placeRole, section.place);
    item->setToolTip(0, section.title);
  }
}

void ManualWindow::goTo(const QString& place) {
  text_->setSource(QUrl(place), QTextDocument::MarkdownResource);
}

void ManualWindow::follow(const QUrl& link) {
  if (!link.scheme().isEmpty()) return void(QDesktopServices::openUrl(link));
  goTo(link.path().isEmpty() ? file_ + '#' + link.fragment() : link.toString());
}

void ManualWindow::takeChapter(const QUrl& place) {
  if (place.fileName() != file_) {
    file_ = place.fileName();
    fitPictures();
    fitTables();
    markFound();
  }
  if (place.hasFragment()) scrollTo(place.fragment());
  choose(place.toString());
}

void ManualWindow::fitPictures() {
  constexpr int widest = 620; // [px]
  for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      const QTextFragment fragment = part.fragment();
      if (!fragment.charFormat().isImageFormat()) continue;
      QTextImageFormat picture = fragment.charFormat().toImageFormat();
      picture.setWidth(std::min(widest, QImage::fromData(manualPicture(picture.name())).width()));
      QTextCursor cursor(text_->document());
      cursor.setPosition(fragment.position());
      cursor.setPosition(fragment.position() + fragment.length(), QTextCursor::KeepAnchor);
      cursor.setCharFormat(picture);
      break; // the parts of this block are others now
    }
  }
}

void ManualWindow::fitTables() {
  for (QTextFrame* frame : text_->document()->rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat format = table->format();
    format.setBorder(1);
    format.setBorderCollapse(true);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(palette().mid());
    format.setCellPadding(4);
    table->setFormat(format);
  }
}

void ManualWindow::scrollTo(const QString& anchor) {
  for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || manualAnchor(block.text()) != anchor) continue;
    const QRectF place = text_->document()->documentLayout()->blockBoundingRect(block);
    text_->verticalScrollBar()->setValue(static_cast<int>(place.top()) - 8);
    return;
  }
}

void ManualWindow::choose(const QString& place) {
  QTreeWidgetItem* chapter = itemNamed(*chapters_, file_);
  for (int i = 0; i < chapters_->topLevelItemCount(); ++i)
    chapters_->topLevelItem(i)->setExpanded(chapters_->topLevelItem(i) == chapter);
  QTreeWidgetItem* item = itemNamed(*chapters_, place);
  chapters_->setCurrentItem(item != nullptr ? item : chapter);
}

void ManualWindow::find(const QString& text) {
  const QStringList words = text.split(' ', Qt::SkipEmptyParts);
  found_->clear();
  for (const Section& section : words.isEmpty() ? std::vector<Section>() : allSections()) {
    if (!holdsAll(section.title + '\n' + section.text, words)) continue;
    const QString name = section.title == section.chapter
                             ? section.chapter
                             : section.title + QStringLiteral(" – ") + section.chapter;
    auto* item = new QListWidgetItem(name + '\n' + excerptOf(section.text, words), found_);
    item->setData(placeRole, section.place);
  }
  if (!words.isEmpty() && found_->count() == 0) {
    auto* none = new QListWidgetItem(tr("Nothing has all of these words"), found_);
    none->setFlags(Qt::NoItemFlags);
  }
  lists_->setCurrentWidget(words.isEmpty() ? static_cast<QWidget*>(chapters_) : found_);
  markFound();
}

void ManualWindow::markFound() {
  QList<QTextEdit::ExtraSelection> marks;
  for (const QString& word : search_->text().split(' ', Qt::SkipEmptyParts))
    for (QTextCursor at = text_->document()->find(word); !at.isNull();
         at = text_->document()->find(word, at)) {
      QTextCharFormat format;
      format.setBackground(palette().highlight());
      format.setForeground(palette().highlightedText());
      marks.append({at, format});
    }
  text_->setExtraSelections(marks);
}

} // namespace espalier
