#include "app/window/frame/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

/// Not in a namespace, as the macro asks: a static library, which the linker else leaves out.
static void useTranslations() {
  Q_INIT_RESOURCE(translations);
}

namespace espalier {
namespace {

const QStringList languages = {"en", "fr"};

// Qt has a word of its own for this key in French, which is on no keyboard.
[[maybe_unused]] const char* const namedAnew = QT_TRANSLATE_NOOP("QShortcut", "Backspace");

void install(const QString& file, const QString& folder) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  if (translator->load(file, folder))
    QCoreApplication::installTranslator(translator);
  else
    delete translator;
}

} // namespace

QString chosenLanguage(const QSettings& settings, const QStringList& ofSystem) {
  const QStringList wished = QStringList(settings.value("language").toString()) + ofSystem;
  for (const QString& each : wished)
    if (QString language = each.section('-', 0, 0); languages.contains(language)) return language;
  return languages.front();
}

void useLanguage(const QSettings& settings) {
  useTranslations();
  const QLocale system = QLocale::system();
  const QString language = chosenLanguage(settings, system.uiLanguages());
  if (language != languages.front()) {
    install("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install("espalier_" + language, QStringLiteral(":/translations"));
  }
  // Months by their names in the language of the window, whatever the system writes: dates may have
  // a language of their own there (LC_TIME).
  if (const QLocale own(language); own.monthName(1) != system.monthName(1))
    QLocale::setDefault(own);
}

} // namespace espalier
