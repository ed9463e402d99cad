// The window in another language: which it has, that each text it shows can be translated, and that
// the French ones have room.
#include "app/window/frame/action_set.h"
#include "app/window/frame/language.h"
#include "app/window/frame/language_flow.h"
#include "tests/app/window/asked_texts.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/shared_data.h"
#include "ui/document/shown_text.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLibraryInfo>
#include <QLineEdit>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabBar>
#include <QTextDocumentFragment>
#include <QTimer>
#include <QToolButton>
#include <QTranslator>
#include <QXmlStreamReader>

namespace espalier {
namespace {

struct LanguageTest : testing::Test {
  QTemporaryDir folder;
  QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
};

TEST_F(LanguageTest, IsTheFirstOfTheSystemThatTheWindowHas) {
  EXPECT_EQ(chosenLanguage(settings, {"fr-CH", "fr", "en"}), "fr");
  EXPECT_EQ(chosenLanguage(settings, {"de-DE", "de", "fr-FR", "en"}), "fr");
  EXPECT_EQ(chosenLanguage(settings, {"en-US", "en", "fr"}), "en");
  EXPECT_EQ(chosenLanguage(settings, {"de-DE", "de"}), "en");
  EXPECT_EQ(chosenLanguage(settings, {"C"}), "en");
  EXPECT_EQ(chosenLanguage(settings, {}), "en");
}

TEST_F(LanguageTest, IsThatOfTheSettingsBefore) {
  settings.setValue("language", "fr");
  EXPECT_EQ(chosenLanguage(settings, {"en-US"}), "fr");
  settings.setValue("language", "en");
  EXPECT_EQ(chosenLanguage(settings, {"fr-FR"}), "en");
  settings.setValue("language", "tlh");
  EXPECT_EQ(chosenLanguage(settings, {"fr-FR"}), "fr") << "a language that the window has not";
}

TEST_F(LanguageTest, IsChosenInTheMenuAndKept) {
  QWidget window;
  ActionSet actions(window);
  LanguageFlow flow(actions, settings);
  EXPECT_TRUE(actions["language_system"]->isChecked());
  const QSignalSpy noted(&flow, &LanguageFlow::noted);
  actions["language_fr"]->trigger();
  EXPECT_EQ(settings.value("language"), "fr");
  ASSERT_EQ(noted.size(), 1);
  EXPECT_TRUE(noted[0][0].toString().contains("starts again"));
  ActionSet again(window);
  const LanguageFlow later(again, settings);
  EXPECT_TRUE(again["language_fr"]->isChecked());
  EXPECT_FALSE(again["language_system"]->isChecked());
}

TEST_F(LanguageTest, IsThatOfTheTextsOfQtAndOfDates) {
  const QLocale before;
  settings.setValue("language", "fr");
  useLanguage(settings);
  EXPECT_EQ(QCoreApplication::translate("espalier::MainWindow", "&File"), "&Fichier");
  EXPECT_EQ(shownText("Contract"), "Contracter");
  EXPECT_EQ(QLocale().toString(QDate(2026, 2, 1), "MMMM"), "février");
  EXPECT_EQ(QKeySequence(Qt::Key_Backspace).toString(QKeySequence::NativeText), "Retour arrière")
      << "as on keyboards, and in the manual";
  const QString ofQt = QLibraryInfo::path(QLibraryInfo::TranslationsPath) + "/qtbase_fr.qm";
  if (QFile::exists(ofQt)) {
    EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel"), "Annuler");
  }
  for (auto* translator : QCoreApplication::instance()->findChildren<QTranslator*>())
    delete translator;
  QLocale::setDefault(before);
}

/// Puts brackets around each text that is translated, those of Qt, too: what stands outside of them
/// is not. Names of keys are as they are: they are compared.
class Brackets : public QTranslator {
public:
  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* context, const char* source, const char* /*comment*/,
                                  int /*n*/) const override {
    const bool isText =
        source != nullptr && *source != '\0' && QByteArrayView(context) != "QShortcut";
    return isText ? "⟦" + QString::fromUtf8(source) + "⟧" : QString();
  }
};

/// With the next named one above it: "review (QPushButton)".
QString nameOf(const QWidget& widget) {
  for (const QWidget* each = &widget; each != nullptr; each = each->parentWidget())
    if (!each->objectName().isEmpty())
      return QStringLiteral("%1 (%2)").arg(each->objectName(), widget.metaObject()->className());
  return widget.metaObject()->className();
}

/// Whether it shows names of libraries, or the manual, which is in English.
bool isData(const QWidget& widget) {
  return widget.objectName() == "about_libraries" ||
         widget.window()->objectName() == "manual_window";
}

struct ShownAt {
  QString text;
  QString where;
};

class ShownTexts {
public:
  explicit ShownTexts(const QWidget& root) {
    add(root);
    for (const QWidget* widget : root.findChildren<QWidget*>())
      add(*widget);
  }
  [[nodiscard]] const QList<ShownAt>& all() const { return all_; }

private:
  void add(const QWidget& widget) {
    if (isData(widget)) return;
    const QString name = nameOf(widget);
    const auto note = [&](const QString& text, const char* what) {
      if (!text.isEmpty()) all_.append({text, name + ' ' + what});
    };
    note(widget.toolTip(), "tip");
    note(widget.statusTip(), "status tip");
    note(widget.whatsThis(), "what's this");
    note(widget.accessibleName(), "accessible name");
    note(widget.accessibleDescription(), "accessible description");
    if (widget.isWindow() || qobject_cast<const QDockWidget*>(&widget) != nullptr)
      note(widget.windowTitle(), "title");
    for (const QAction* action : widget.actions()) {
      note(action->text(), "action");
      note(action->toolTip(), "tip of an action");
      note(action->statusTip(), "status tip of an action");
    }
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) note(label->text(), "label");
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
      note(button->text(), "button");
    if (const auto* group = qobject_cast<const QGroupBox*>(&widget)) note(group->title(), "group");
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
      note(line->placeholderText(), "placeholder");
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
      for (int i = 0; i < tabs->count(); ++i)
        note(tabs->tabText(i), "tab");
    if (const auto* number = qobject_cast<const QSpinBox*>(&widget)) {
      note(number->prefix(), "prefix");
      note(number->suffix(), "suffix");
      note(number->specialValueText(), "special value");
    }
    if (const auto* number = qobject_cast<const QDoubleSpinBox*>(&widget)) {
      note(number->prefix(), "prefix");
      note(number->suffix(), "suffix");
      note(number->specialValueText(), "special value");
    }
    if (const auto* choice = qobject_cast<const QComboBox*>(&widget))
      for (int i = 0; i < choice->count(); ++i) {
        note(choice->itemText(i), "item");
        note(choice->itemData(i, Qt::ToolTipRole).toString(), "tip of an item");
      }
    else if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
             view != nullptr && view->model() != nullptr &&
             qobject_cast<const QHeaderView*>(view) == nullptr)
      addModel(*view->model(), {}, name);
  }

  void addModel(const QAbstractItemModel& model, const QModelIndex& parent, const QString& name) {
    for (const int role : {Qt::DisplayRole, Qt::ToolTipRole}) {
      for (int column = 0; column < model.columnCount(parent); ++column) {
        const QVariant head = model.headerData(column, Qt::Horizontal, role);
        if (!head.toString().isEmpty() && !parent.isValid())
          all_.append({head.toString(), name + " head"});
      }
      for (int row = 0; row < std::min(model.rowCount(parent), 60); ++row)
        for (int column = 0; column < model.columnCount(parent); ++column) {
          const QVariant cell = model.index(row, column, parent).data(role);
          if (!cell.toString().isEmpty()) all_.append({cell.toString(), name + " cell"});
        }
    }
    for (int row = 0; row < std::min(model.rowCount(parent), 60); ++row)
      if (const QModelIndex child = model.index(row, 0, parent); model.hasChildren(child))
        addModel(model, child, name);
  }

  QList<ShownAt> all_;
};

/// What is left of a text without that in brackets, its tags, and what no language changes.
QString untranslated(QString text) {
  if (Qt::mightBeRichText(text)) text = QTextDocumentFragment::fromHtml(text).toPlainText();
  static const QRegularExpression innermost("⟦[^⟦⟧]*⟧");
  while (text.contains(innermost))
    text.remove(innermost);
  static const QRegularExpression same(
      "\\b(MTG|Espalier|English|Français|Ctrl|Shift|Alt|Del|Esc|Space|Return|Enter|Tab|Backspace|"
      "Num|Home|End|PgUp|PgDown|Left|Right|Up|Down|Ins|F[0-9]+|XYZ|kg)\\b");
  text.remove(same);
  static const QRegularExpression word("[A-Za-zÀ-ÿ]{3,}");
  return word.match(text).hasMatch() ? text.simplified() : QString();
}

/// Labels and buttons that are seen but have less room than their text needs. The status line and
/// the tabs of docks end in dots where there is no more, in every language, and give the whole as a
/// tip; long names of methods do so in their list.
QStringList cutOff(const QWidget& root) {
  QStringList found;
  for (const QWidget* widget : root.findChildren<QWidget*>()) {
    const bool isSeen = widget->isVisible() && !widget->visibleRegion().isEmpty();
    if (!isSeen || nameOf(*widget->parentWidget()).startsWith("status_line")) continue;
    QString text;
    int needed = 0;
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      text = label->text();
      if (!label->wordWrap() && !Qt::mightBeRichText(text))
        needed = label->fontMetrics().size(0, text).width(); // of its longest line
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
      const auto* tool = qobject_cast<const QToolButton*>(widget);
      if (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly &&
          !tool->icon().isNull())
        continue;
      text = button->text().remove('&');
      const int icon = button->icon().isNull() ? 0 : button->iconSize().width() + 4;
      needed = button->fontMetrics().horizontalAdvance(text) + icon;
    }
    if (!text.isEmpty() && widget->width() < needed)
      found.append(QStringLiteral("%1: %2, %3 of %4 px")
                       .arg(nameOf(*widget), text)
                       .arg(widget->width())
                       .arg(needed));
  }
  return found;
}

class TranslationTest : public test::WindowTest {
protected:
  using Look = std::function<void(const QWidget&)>;

  /// Opens a scan, makes its skeleton, runs each command, shows each panel, and looks at the window
  /// after each, and at each dialog that opens.
  void walk(const Look& take) {
    const Look look = [&take](const QWidget& widget) {
      for (int i = 0; i < 10; ++i) // layouts follow their contents in events
        QCoreApplication::processEvents();
      take(widget);
    };
    look(window());
    window().open({writeScan("plant.xyz")});
    waitForJob();
    auto& pipeline = *window().findChild<PipelinePanel*>();
    const PipelineOptions byDefault = pipeline.options();
    PipelineOptions options = byDefault;
    options.set("wires.method=catenaries"); // a step that notes something: there is no wire
    pipeline.setOptions(options);
    action("reconstruct").trigger();
    waitForJob();
    const QString said = window().banner().text();
    EXPECT_TRUE(said.contains(shownText("no wire was found"))) << said.toStdString();
    window().resize(1280, 800);
    look(window());
    pipeline.setOptions(byDefault);
    QTimer dialogs;
    QObject::connect(&dialogs, &QTimer::timeout, [&] {
      if (QWidget* menu = QApplication::activePopupWidget()) menu->close();
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      if (qobject_cast<QFileDialog*>(dialog) == nullptr) take(*dialog); // that is Qt's
      dialog->reject();
    });
    dialogs.start(0);
    for (QAction* each : window().actionSet().all()) {
      const QString id = each->objectName();
      const bool isEnd = id == "quit" || id == "new_plant" || id == "close_plant" ||
                         id == "sample_plant" || id.startsWith("language_");
      if (isEnd || !each->isEnabled()) continue;
      each->trigger();
      waitForJob();
      look(window());
      for (const QWidget* other : QApplication::topLevelWidgets())
        if (other != &window() && other->isVisible() && other->inherits("QDialog")) look(*other);
    }
    for (QDockWidget* dock : window().findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      look(window());
    }
    dialogs.stop();
  }
};

TEST_F(TranslationTest, CoversAllThatTheWindowShows) {
  Brackets brackets;
  QApplication::installTranslator(&brackets);
  restart();
  QMap<QString, QString> found;
  int count = 0;
  walk([&](const QWidget& root) {
    const ShownTexts texts(root);
    for (const ShownAt& shown : texts.all()) {
      ++count;
      QString text = shown.text;
      text.remove(path("")); // names of files
      text.remove("plant.xyz");
      const QString rest = untranslated(text);
      if (!rest.isEmpty()) found[rest] = shown.where;
    }
  });
  QApplication::removeTranslator(&brackets);
  EXPECT_GT(count, 10'000);
  for (auto each = found.begin(); each != found.end(); ++each)
    ADD_FAILURE() << each.value().toStdString() << ": " << each.key().toStdString();
}

/// All parts of a text that this finds, sorted.
QStringList partsOf(const QString& text, const QRegularExpression& part) {
  QStringList parts;
  for (auto found = part.globalMatch(text); found.hasNext();)
    parts.append(found.next().captured());
  parts.sort();
  return parts;
}

TEST(TranslationFile, KeepsValuesTagsKeysAndLinesOfEachText) {
  QFile file(QString::fromStdString(
      (test::sourceFolder() / "resources/translations/espalier_fr.ts").string()));
  ASSERT_TRUE(file.open(QFile::ReadOnly));
  const QList<QRegularExpression> kept = {
      QRegularExpression("%[1-9]"),     QRegularExpression(R"(</?\w[^<>]*>)"),
      QRegularExpression(R"(\{\w+\})"), QRegularExpression(R"(&(?=\w))"),
      QRegularExpression("\n"),         QRegularExpression("…$")};
  QString source;
  int count = 0;
  bool isCounted = false;
  for (QXmlStreamReader xml(&file); !xml.atEnd(); xml.readNext()) {
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("message"))
      isCounted = xml.attributes().hasAttribute("numerus");
    else if (xml.name() == QLatin1String("source"))
      source = xml.readElementText();
    else if (xml.name() == QLatin1String(isCounted ? "numerusform" : "translation")) {
      const QString french = xml.readElementText();
      for (const QRegularExpression& part : kept)
        EXPECT_EQ(partsOf(source, part), partsOf(french, part))
            << source.toStdString() << " = " << french.toStdString();
      ++count;
    }
  }
  EXPECT_GT(count, 3000);
}

TEST_F(TranslationTest, HasRoomForTheFrenchTexts) {
  QTranslator french;
  ASSERT_TRUE(french.load("espalier_fr", ":/translations"));
  QApplication::installTranslator(&french);
  restart();
  EXPECT_TRUE(window().menuBar()->actions().front()->text().contains("Fichier"));
  QStringList found;
  walk([&](const QWidget& root) { found += cutOff(root); });
  QApplication::removeTranslator(&french);
  found.removeDuplicates();
  for (const QString& each : found)
    ADD_FAILURE() << each.toStdString();
}

TEST_F(TranslationTest, SaysInFrenchWhatIsWrongWithAFile) {
  QTranslator french;
  ASSERT_TRUE(french.load("espalier_fr", ":/translations"));
  QApplication::installTranslator(&french);
  restart();
  const auto saidOf = [this](const QString& name, const QByteArray& text) {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QFile::WriteOnly) && file.write(text) == text.size());
    file.close();
    window().open({path(name)});
    waitForJob();
    return window().banner().text();
  };
  const QString space(QChar(0xA0));
  EXPECT_EQ(saidOf("vide.ply", ""), QStringLiteral("vide.ply%1: est vide%1: copiez-le ou "
                                                   "exportez-le à nouveau")
                                        .arg(space));
  const QString line = saidOf("plante.swc", "1 2 3\n");
  EXPECT_TRUE(line.startsWith(QStringLiteral("plante.swc, ligne 1%1: 7 nombres").arg(space)))
      << line.toStdString();
  QApplication::removeTranslator(&french);
}

} // namespace
} // namespace espalier
