#include "ui/panels/panel_button.h"

#include <QAction>
#include <QToolButton>

namespace espalier {

QToolButton* panelButton(QAction& action, const QString& text) {
  auto* button = new QToolButton;
  button->setDefaultAction(&action);
  button->setProperty("role", "panel");
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setMinimumWidth(28);
  if (text.isEmpty()) return button;
  button->setText(text);
  // Whenever the action changes, it writes its text on the button again.
  QObject::connect(&action, &QAction::changed, button, [button, text] { button->setText(text); });
  button->setAccessibleName(action.property("name").toString());
  return button;
}

QToolButton* sharingButton(QAction& action, const QString& text) {
  QToolButton* button = panelButton(action, text);
  button->setMinimumWidth(40);
  button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return button;
}

QToolButton* keyedButton(QAction& action) {
  QToolButton* button = sharingButton(action);
  const auto showKey = [button, &action] { // after the button has taken the action's text
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    if (!key.isEmpty()) button->setText(key + QStringLiteral("  ") + action.text());
  };
  QObject::connect(&action, &QAction::changed, button, showKey);
  showKey();
  return button;
}

void passFocus(const QWidget& from, QWidget& to) {
  if (from.window()->focusWidget() == &from) to.setFocus(Qt::OtherFocusReason);
}

} // namespace espalier
