// The window in another language: which it has, and what its translation keeps of each text.
#include "app/window/frame/action_set.h"
#include "app/window/frame/language.h"
#include "app/window/frame/language_flow.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/shared_data.h"
#include "ui/document/shown_text.h"

#include <QAction>
#include <QFile>
#include <QLibraryInfo>
#include <QRegularExpression>
#include <QSignalSpy>
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
  const QString ofQt = QLibraryInfo::path(QLibraryInfo::TranslationsPath) + "/qtbase_fr.qm";
  if (QFile::exists(ofQt)) {
    EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel"), "Annuler");
  }
  for (auto* translator : QCoreApplication::instance()->findChildren<QTranslator*>())
    delete translator;
  QLocale::setDefault(before);
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

} // namespace
} // namespace espalier
