#include "app/report/manual_pages.h"

#include "app/report/html_style.h"
#include "ui/dialogs/manual_chapters.h"

#include <QImage>
#include <QSet>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextList>
#include <QTextTable>
#include <QUrl>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

/// Beside the style of reports: the list of chapters, which stands beside the text where there is
/// room, and above it on a phone.
constexpr auto manualStyle = R"css(
.manual{display:grid;grid-template-columns:15rem minmax(0,46rem);gap:2.5rem;max-width:66rem}
.manual p,.manual ul,.manual ol{max-width:none}
.manual nav{font-size:.9rem}
.manual nav ul{list-style:none;margin:0;padding:0;position:sticky;top:1rem}
.manual nav a{display:block;padding:.2rem .5rem;border-radius:4px;color:inherit;text-decoration:none}
.manual nav a:hover,.manual nav a[aria-current]{background:var(--panel)}
.manual nav a[aria-current]{font-weight:600}
.manual a{color:var(--accent)}
.manual h1{border-bottom:3px solid var(--accent);padding-bottom:.5rem}
.manual h3{font-size:1.05rem;margin:1.6rem 0 .4rem}
.manual img{display:block;max-width:100%;height:auto;border:1px solid var(--line);
border-radius:6px;background:#fff}
.manual pre{background:var(--panel);border-radius:6px;padding:.6rem .8rem;overflow-x:auto}
.manual code,.manual pre{font-family:ui-monospace,"DejaVu Sans Mono",monospace;font-size:.85em}
.manual td code{overflow-wrap:anywhere}
.manual th,.manual td{padding-right:1rem}
.manual .next{margin-top:2.5rem;border-top:1px solid var(--line);padding-top:.8rem}
@media (max-width:52rem){.manual{display:block}.manual nav{margin-bottom:1rem}
.manual nav ul{position:static;columns:2}.manual .cards tr{display:block}}
@media print{.manual{display:block}.manual nav,.manual .next{display:none}
.manual a{color:inherit;text-decoration:none}}
)css";

QString htmlName(const QString& chapter) {
  return chapter == QStringLiteral("README.md") ? QStringLiteral("index.html")
                                                : chapter.chopped(3) + QStringLiteral(".html");
}

/// "files.md#projects" becomes "files.html#projects"; what leads elsewhere stays.
QString htmlLink(const QString& link) {
  const QString file = link.section('#', 0, 0);
  if (!file.endsWith(QStringLiteral(".md")) || file.contains('/')) return link;
  return htmlName(file) + link.mid(file.size());
}

/// Writes what Qt reads from Markdown as HTML.
class ChapterWriter {
public:
  explicit ChapterWriter(const QString& markdown) {
    document_.setMarkdown(markdown);
    addFrame(*document_.rootFrame());
    closeLists(0);
    endCode();
  }

  [[nodiscard]] QString html() const { return html_; }
  [[nodiscard]] QSet<QString> pictures() const { return pictures_; }

private:
  void addFrame(const QTextFrame& frame) {
    for (auto at = frame.begin(); !at.atEnd(); ++at)
      if (const auto* table = qobject_cast<const QTextTable*>(at.currentFrame()))
        addTable(*table);
      else if (at.currentFrame() != nullptr)
        addFrame(*at.currentFrame());
      else
        addBlock(at.currentBlock());
  }

  void addTable(const QTextTable& table) {
    closeLists(0);
    endCode();
    constexpr int mostTogether = 10; // rows that a page of A4 is not to part
    html_ += table.rows() > mostTogether + 1
                 ? QStringLiteral("<div class=\"wide\"><table class=\"cards long\">\n")
                 : QStringLiteral("<div class=\"wide\"><table class=\"cards\">\n");
    QStringList names;
    for (int row = 0; row < table.rows(); ++row) {
      html_ += row == 0 ? QStringLiteral("<thead><tr>") : QStringLiteral("<tr>");
      for (int column = 0; column < table.columns(); ++column) {
        const QTextBlock block = table.cellAt(row, column).firstCursorPosition().block();
        if (row == 0) {
          names.append(block.text());
          html_ += QStringLiteral("<th class=\"word\" scope=\"col\">%1</th>").arg(textOf(block));
        } else if (!block.text().isEmpty() || column == 0) // an empty one is no line of a card
          html_ += QStringLiteral("<td class=\"word\" data-name=\"%1\">%2</td>")
                       .arg(names[column].toHtmlEscaped(), textOf(block));
        else
          html_ += QStringLiteral("<td></td>");
      }
      html_ += row == 0 ? QStringLiteral("</tr></thead>\n<tbody>\n") : QStringLiteral("</tr>\n");
    }
    html_ += QStringLiteral("</tbody></table></div>\n");
  }

  void addBlock(const QTextBlock& block) {
    const QTextBlockFormat format = block.blockFormat();
    if (format.hasProperty(QTextFormat::BlockCodeFence) ||
        format.hasProperty(QTextFormat::BlockCodeLanguage)) {
      closeLists(0);
      html_ +=
          (isCode_ ? QStringLiteral("\n") : QStringLiteral("<pre>")) + block.text().toHtmlEscaped();
      isCode_ = true;
      return;
    }
    endCode();
    if (const QTextList* list = block.textList()) {
      addItem(*list, block);
      return;
    }
    closeLists(0);
    if (const int level = format.headingLevel(); level > 0)
      html_ += QStringLiteral("<h%1 id=\"%2\">%3</h%1>\n")
                   .arg(QString::number(level), manualAnchor(block.text()).toHtmlEscaped(),
                        textOf(block));
    else if (!block.text().isEmpty())
      html_ += QStringLiteral("<p>%1</p>\n").arg(textOf(block));
  }

  void addItem(const QTextList& list, const QTextBlock& block) {
    const auto depth = static_cast<std::size_t>(list.format().indent());
    closeLists(depth);
    if (lists_.size() == depth)
      html_ += QStringLiteral("</li>\n");
    else
      while (lists_.size() < depth) {
        const QString name = list.format().style() == QTextListFormat::ListDecimal ? "ol" : "ul";
        html_ += QStringLiteral("<%1>\n").arg(name);
        lists_.push_back(name);
      }
    html_ += QStringLiteral("<li>") + textOf(block);
  }

  void closeLists(std::size_t depth) {
    while (lists_.size() > depth) {
      html_ += QStringLiteral("</li>\n</%1>\n").arg(lists_.back());
      lists_.pop_back();
    }
  }

  void endCode() {
    if (isCode_) html_ += QStringLiteral("</pre>\n");
    isCode_ = false;
  }

  QString textOf(const QTextBlock& block) {
    QString html;
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      const QTextCharFormat format = part.fragment().charFormat();
      if (format.isImageFormat()) {
        html += picture(format.toImageFormat());
        continue;
      }
      QString text = part.fragment().text().toHtmlEscaped();
      text.replace(QChar::LineSeparator, QStringLiteral("<br/>"));
      if (format.fontFixedPitch() || !format.fontFamilies().toStringList().isEmpty())
        text = QStringLiteral("<code>%1</code>").arg(text);
      if (format.fontWeight() > QFont::Medium && block.blockFormat().headingLevel() == 0 &&
          !isHead(block))
        text = QStringLiteral("<b>%1</b>").arg(text);
      if (format.fontItalic()) text = QStringLiteral("<i>%1</i>").arg(text);
      if (format.isAnchor())
        text = QStringLiteral("<a href=\"%1\">%2</a>")
                   .arg(htmlLink(format.anchorHref()).toHtmlEscaped(), text);
      html += text;
    }
    return html;
  }

  /// Whether it stands in the first row of a table, which is bold throughout.
  [[nodiscard]] bool isHead(const QTextBlock& block) const {
    const QTextTable* table = QTextCursor(block).currentTable();
    return table != nullptr && table->cellAt(block.position()).row() == 0;
  }

  QString picture(const QTextImageFormat& format) {
    const QString name = format.name();
    pictures_.insert(name);
    const QImage image = QImage::fromData(manualPicture(name));
    return QStringLiteral("<img src=\"%1\" alt=\"%2\" width=\"%3\" height=\"%4\"/>")
        .arg(name.toHtmlEscaped(), format.stringProperty(QTextFormat::ImageAltText).toHtmlEscaped(),
             QString::number(image.width()), QString::number(image.height()));
  }

  QTextDocument document_;
  QString html_;
  QSet<QString> pictures_;
  std::vector<QString> lists_; // those that are open, "ul" or "ol"
  bool isCode_ = false;
};

QString chapterList(const QString& current) {
  QString html = QStringLiteral("<nav><ul>\n");
  for (const ManualChapter& chapter : manualChapters())
    html += QStringLiteral("<li><a href=\"%1\"%2>%3</a></li>\n")
                .arg(htmlName(chapter.file),
                     chapter.file == current ? QStringLiteral(" aria-current=\"page\"") : QString(),
                     chapter.title.toHtmlEscaped());
  return html + QStringLiteral("</ul></nav>\n");
}

QByteArray pageOf(const ManualChapter& chapter, const QString& body, const ManualChapter* next) {
  const QString onward = next == nullptr
                             ? QString()
                             : QStringLiteral("<p class=\"next\"><a href=\"%1\">%2 →</a></p>\n")
                                   .arg(htmlName(next->file), next->title.toHtmlEscaped());
  return QStringLiteral(
             "<!DOCTYPE html>\n"
             "<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
             "<meta charset=\"utf-8\"/>\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
             "<title>%1</title>\n<link rel=\"stylesheet\" href=\"manual.css\"/>\n"
             "</head>\n<body>\n<main class=\"manual\">\n%2<article>\n%3%4</article>\n"
             "</main>\n</body>\n</html>\n")
      .arg(chapter.title.toHtmlEscaped(), chapterList(chapter.file), body, onward)
      .toUtf8();
}

} // namespace

std::vector<ManualPage> manualPages() {
  std::vector<ManualPage> pages;
  QSet<QString> pictures;
  const std::vector<ManualChapter>& chapters = manualChapters();
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    const ChapterWriter writer(chapters[i].text);
    pages.push_back(
        {htmlName(chapters[i].file),
         pageOf(chapters[i], writer.html(), i + 1 < chapters.size() ? &chapters[i + 1] : nullptr)});
    pictures.unite(writer.pictures());
  }
  QStringList names(pictures.begin(), pictures.end());
  names.sort();
  for (const QString& name : std::as_const(names))
    pages.push_back({name, manualPicture(name)});
  pages.push_back({QStringLiteral("manual.css"), (htmlStyle() + manualStyle).toUtf8()});
  return pages;
}

} // namespace espalier
