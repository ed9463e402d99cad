// The manual in the window: its chapters, links and search, and where F1 opens it.
#include "app/window/frame/help_flow.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/manual.h"
#include "tests/support/shared_data.h"
#include "ui/dialogs/manual_chapters.h"
#include "ui/document/manual_place.h"
#include "ui/tools/registry.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace espalier {
namespace {

class ManualTest : public test::WindowTest {
protected:
  QDialog& manual() { return find<QDialog>("manual_window"); }
  QTextBrowser& text() { return *manual().findChild<QTextBrowser*>(); }
  QTreeWidget& chapters() { return *manual().findChild<QTreeWidget*>("manual_chapters"); }
  QListWidget& found() { return *manual().findChild<QListWidget*>("manual_found"); }
  QString place() { return chapters().currentItem()->text(0); }
  /// The text of the first line that is whole in the page.
  QString firstLine() { return text().cursorForPosition({4, 24}).block().text(); }
};

/// "files.md", and "files.md#projects" for each heading in it.
std::multiset<QString> allPlaces() {
  std::multiset<QString> places;
  for (const ManualChapter& chapter : manualChapters()) {
    places.insert(chapter.file);
    QTextDocument document;
    document.setMarkdown(chapter.text);
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
      if (block.blockFormat().headingLevel() > 1)
        places.insert(chapter.file + '#' + manualAnchor(block.text()));
  }
  return places;
}

/// What links and pictures of a chapter name, "files.md#projects".
std::set<QString> linksOf(const QString& text) {
  static const QRegularExpression link(QStringLiteral("\\]\\(([^)]+)\\)"));
  std::set<QString> links;
  for (const QRegularExpressionMatch& match : link.globalMatch(text))
    links.insert(match.captured(1));
  return links;
}

TEST_F(ManualTest, HasTheFirstPlantInFrench) {
  const std::vector<ManualChapter> french = manualChaptersIn("fr");
  ASSERT_EQ(french.size(), manualChapters().size());
  const ManualChapter& first = french.at(1);
  EXPECT_EQ(first.file, "first-plant.md");
  EXPECT_EQ(first.title, QString::fromUtf8("Une première plante en dix minutes"));
  EXPECT_TRUE(french.front().text.contains(first.title)) << "the page that lists them";
  EXPECT_EQ(first.text.count("\n## "), manualChapters().at(1).text.count("\n## "));
  const std::multiset<QString> places = allPlaces();
  for (const QString& link : linksOf(first.text))
    EXPECT_TRUE(places.contains(link) || !manualPicture(link).isEmpty()) << link.toStdString();
  EXPECT_EQ(french.at(2).text, manualChapters().at(2).text) << "is in English alone";
}

TEST_F(ManualTest, ListsItsChaptersAndShowsOne) {
  action("manual").trigger();
  ASSERT_EQ(chapters().topLevelItemCount(), static_cast<int>(test::manualFiles().size()));
  QTreeWidgetItem* files = chapters().findItems("Files and projects", Qt::MatchExactly).value(0);
  ASSERT_NE(files, nullptr);
  emit chapters().itemClicked(files, 0);
  EXPECT_TRUE(text().toPlainText().contains("Save Project As…"));
  EXPECT_TRUE(files->isExpanded());
  QTreeWidgetItem* projects = chapters().findItems("Projects", Qt::MatchRecursive).value(0);
  ASSERT_NE(projects, nullptr);
  EXPECT_EQ(projects->parent(), files);
  emit chapters().itemClicked(projects, 0);
  EXPECT_EQ(firstLine(), "Projects");
  EXPECT_EQ(chapters().currentItem(), projects);
}

TEST_F(ManualTest, HasTheTablesOfTheRegistry) {
  action("manual").trigger();
  text().setSource(QUrl("methods.md"), QTextDocument::MarkdownResource);
  const QString shown = text().toPlainText();
  EXPECT_TRUE(shown.contains("Branch structure graph"));
  EXPECT_TRUE(shown.contains("contract.radius"));
  EXPECT_TRUE(shown.contains("contract.method=geodesic_centroid, the default"));
  for (const ManualChapter& chapter : manualChapters())
    EXPECT_FALSE(chapter.text.contains("{methods") || chapter.text.contains("{options"))
        << chapter.file.toStdString();
}

TEST_F(ManualTest, FitsItsPicturesToThePage) {
  action("manual").trigger();
  for (const auto& [chapter, picture, width] :
       {std::tuple{"correct.md", "section.png",
                   double(QImage::fromData(manualPicture("section.png")).width())},
        {"window.md", "editor.png", 620.0}}) {
    ASSERT_LE(width, 620);
    text().setSource(QUrl(chapter), QTextDocument::MarkdownResource);
    std::map<QString, double> widths;
    for (const QTextFormat& format : text().document()->allFormats())
      if (format.isImageFormat() && format.hasProperty(QTextFormat::ImageWidth))
        widths[format.toImageFormat().name()] = format.toImageFormat().width();
    EXPECT_EQ(widths[picture], width);
    EXPECT_EQ(text().horizontalScrollBar()->maximum(), 0) << "all is as wide as the page";
  }
}

TEST_F(ManualTest, GoesAlongLinksBackAndForward) {
  action("manual").trigger();
  emit text().anchorClicked(QUrl("formats.md#a-part-of-a-scan"));
  EXPECT_EQ(firstLine(), "A part of a scan");
  emit text().anchorClicked(QUrl("troubleshooting.md"));
  EXPECT_TRUE(text().toPlainText().startsWith("Troubleshooting"));
  auto* back = manual().findChild<QToolButton*>("manual_back");
  auto* forward = manual().findChild<QToolButton*>("manual_forward");
  EXPECT_FALSE(forward->isEnabled());
  back->click();
  EXPECT_EQ(firstLine(), "A part of a scan");
  EXPECT_EQ(chapters().currentItem()->text(0), "A part of a scan");
  forward->click();
  EXPECT_TRUE(text().toPlainText().startsWith("Troubleshooting"));
}

TEST_F(ManualTest, SearchesAllChapters) {
  action("manual").trigger();
  auto* search = manual().findChild<QLineEdit*>("manual_search");
  QTest::keyClicks(search, "chaos theory of turnips");
  EXPECT_TRUE(found().isVisible());
  EXPECT_EQ(found().count(), 1);
  EXPECT_EQ(found().item(0)->flags(), Qt::NoItemFlags) << "says that there is nothing";
  search->clear();
  EXPECT_TRUE(chapters().isVisible());
  QTest::keyClicks(search, "handles paraboloid");
  ASSERT_GE(found().count(), 1);
  EXPECT_TRUE(found().item(0)->text().startsWith("The envelope of the crown"));
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(firstLine(), "The envelope of the crown");
  EXPECT_FALSE(text().extraSelections().isEmpty()) << "the words are marked";
}

TEST_F(ManualTest, HasEveryChapterPictureAndHeadingThatItNames) {
  const std::multiset<QString> places = allPlaces();
  for (const QString& place : places)
    EXPECT_EQ(places.count(place), 1U) << place.toStdString();
  std::set<std::string> listed{"README.md"};
  const std::regex link(R"(\]\(([^)\s]+)\))");
  for (const ManualChapter& chapter : manualChapters()) {
    EXPECT_FALSE(chapter.title.isEmpty());
    EXPECT_LE(chapter.text.count('\n'), 300 + 700 * chapter.text.contains("contract.method"))
        << chapter.file.toStdString() << " holds two things";
    const std::string markdown = chapter.text.toStdString();
    for (std::sregex_iterator at(markdown.begin(), markdown.end(), link), end; at != end; ++at) {
      const QString target = QString::fromStdString((*at)[1]);
      SCOPED_TRACE(chapter.file.toStdString() + ": " + target.toStdString());
      if (target.endsWith(".png")) {
        EXPECT_FALSE(QImage::fromData(manualPicture(target)).isNull());
      } else if (!target.contains("://")) {
        EXPECT_TRUE(places.contains(target.startsWith('#') ? chapter.file + target : target));
      }
      listed.insert(target.toStdString());
    }
  }
  for (const auto& file :
       std::filesystem::directory_iterator(test::sourceFolder() / "resources/manual"))
    EXPECT_TRUE(file.is_directory() || // of chapters in another language
                listed.contains(file.path().filename().string()))
        << file.path().filename() << " is in no chapter";
}

// packaging/manual_pictures can make each of them again.
TEST_F(ManualTest, HasOnlyPicturesThatAreMadeByTheProgram) {
  std::string makers;
  for (const char* source : {"window_pictures.cpp", "option_pictures.cpp"}) {
    std::ifstream in(test::sourceFolder() / "tests/pictures" / source);
    makers.append(std::istreambuf_iterator<char>(in), {});
  }
  int pictures = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(test::sourceFolder() / "resources/manual")) {
    const std::string name = file.path().filename().string();
    if (file.path().extension() != ".png") continue;
    ++pictures;
    if (!name.starts_with("option-")) {
      EXPECT_THAT(makers, testing::HasSubstr('"' + name + '"'));
    }
  }
  EXPECT_GT(pictures, 15);
}

TEST_F(ManualTest, DescribesEachPanelToolAndDialogAtAPlaceThatIsThere) {
  const std::multiset<QString> places = allPlaces();
  const auto docks = window().findChildren<QDockWidget*>();
  ASSERT_GT(docks.size(), 15);
  for (const QDockWidget* dock : docks)
    EXPECT_TRUE(places.contains(manualPlaceOf(dock))) << dock->objectName().toStdString();
  for (const ToolEntry& tool : tools())
    EXPECT_TRUE(places.contains(tool.manual)) << tool.id.toStdString();
  // Dialogs are made when they are needed, so their sources are read.
  const std::regex named(R"x(setManualPlace\(\*this, QStringLiteral\("([^"]+)"\)\))x");
  int dialogs = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(test::sourceFolder() / "ui/dialogs")) {
    const auto textOf = [](const std::filesystem::path& path) {
      std::ifstream in(path);
      return std::string(std::istreambuf_iterator<char>(in), {});
    };
    if (file.path().extension() != ".h" ||
        textOf(file.path()).find(": public QDialog") == std::string::npos)
      continue;
    ++dialogs;
    const std::string source = textOf(std::filesystem::path(file.path()).replace_extension(".cpp"));
    std::smatch place;
    ASSERT_TRUE(std::regex_search(source, place, named)) << file.path();
    EXPECT_TRUE(places.contains(QString::fromStdString(place[1]))) << place[1];
  }
  EXPECT_GT(dialogs, 7);
}

TEST_F(ManualTest, OpensAtWhatOneIsIn) {
  open({writeScan("scan.xyz"), writeFork("fork.mtg")});
  view().setFocus();
  action("tool_trace").trigger();
  key(Qt::Key_F1);
  EXPECT_EQ(place(), "Along the points");
  manual().close();
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  action("show_node_table").trigger();
  auto* filter = find<QDockWidget>("node_table").findChild<QLineEdit*>();
  filter->setFocus();
  ASSERT_TRUE(filter->hasFocus());
  QTest::keyClick(filter, Qt::Key_F1);
  EXPECT_EQ(place(), "The table of nodes");
  action("tool_measure").trigger();
  view().setFocus();
  action("manual").trigger();
  EXPECT_EQ(place(), "Measuring") << "in the window that is open";
  EXPECT_EQ(window().findChildren<QDialog*>("manual_window").size(), 1);
}

TEST_F(ManualTest, OpensBesideADialogAtItsChapter) {
  action("palette").trigger();
  auto* field = find<QDialog>("command_palette").findChild<QLineEdit*>();
  field->setFocus();
  QTest::keyClick(field, Qt::Key_F1);
  EXPECT_EQ(place(), "Commands");
}

} // namespace
} // namespace espalier
