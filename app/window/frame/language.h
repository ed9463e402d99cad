#pragma once

#include <QString>
#include <QStringList>

class QSettings;

namespace espalier {

/// The language of the window, "en" or "fr": the one that the settings name, else the first of
/// `ofSystem` that it has, else English.
/// @param ofSystem as QLocale::uiLanguages() lists them: "fr-FR", "fr", "en"
[[nodiscard]] QString chosenLanguage(const QSettings& settings, const QStringList& ofSystem);

/// Gives the application the language that is chosen: its own texts, those of Qt where these are
/// installed, and dates. Once, before the window is made: what was shown before stays as it is.
/// The command line does not call it: what it prints is read by other programs.
void useLanguage(const QSettings& settings);

} // namespace espalier
