#include "app/window/frame/language_flow.h"

#include "app/window/frame/action_set.h"

#include <QAction>
#include <QActionGroup>
#include <QSettings>

namespace espalier {

LanguageFlow::LanguageFlow(ActionSet& actions, QSettings& settings) : settings_(settings) {
  actions.beginSection(tr("Language"));
  auto* group = new QActionGroup(this);
  const auto add = [&](const QString& language, const QString& text) {
    QAction* action =
        actions.add({.id = "language_" + (language.isEmpty() ? "system" : language),
                     .text = text,
                     .help = tr("Changes the language of the window when Espalier starts again"),
                     .isCheckable = true,
                     .menu = "view/language"},
                    [this, language] { choose(language); });
    group->addAction(action);
    action->setChecked(settings_.value("language").toString() == language);
  };
  add({}, tr("As the System"));
  add("en", QStringLiteral("English")); // each by the name that its speakers know
  add("fr", QStringLiteral("Français"));
}

void LanguageFlow::choose(const QString& language) {
  settings_.setValue("language", language);
  emit noted(tr("The language changes when Espalier starts again"));
}

} // namespace espalier
