#include "app/window/frame/help_flow.h"

#include "app/window/frame/action_set.h"
#include "ui/dialogs/command_palette.h"
#include "ui/dialogs/key_bindings.h"
#include "ui/dialogs/manual_window.h"
#include "ui/dialogs/shortcut_sheet.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace espalier {

HelpFlow::HelpFlow(const Parts& parts) : parts_(parts) {
  addActions();
  parts_.actions.place("help", {"manual", "shortcuts", "palette", "", "about"});
  keys_ = new KeyBindings(parts_.actions.all(), {"leave", "accept"}, parts_.settings, this);
  connect(keys_, &KeyBindings::changed, this, &HelpFlow::hintChanged);
}

void HelpFlow::addActions() {
  ActionSet& actions = parts_.actions;
  actions.beginSection(tr("Help"));
  actions.add({.id = "palette",
               .text = tr("Find a Command…"),
               .help = tr("Runs any command by its name"),
               .icon = "search",
               .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P)},
              [this] { showPalette(); });
  actions.add({.id = "manual",
               .text = tr("Manual"),
               .help = tr("How things are done"),
               .icon = "info",
               .keys = QKeySequence(Qt::Key_F1)},
              [this] { (new ManualWindow(":/manual/manual.md", &parts_.window))->show(); });
  actions.add({.id = "shortcuts",
               .text = tr("Shortcuts"),
               .help = tr("Shows all keys on one sheet"),
               .icon = "keyboard",
               .keys = QKeySequence(Qt::Key_Question)},
              [this] { (new ShortcutSheet(*keys_, &parts_.window))->show(); });
  actions.add({.id = "about", .text = tr("About Espalier"), .help = tr("What this is")},
              [this] { showAbout(); });
}

void HelpFlow::showPalette() {
  auto* palette = new CommandPalette(parts_.actions.all(), &parts_.window);
  palette->move(
      parts_.window.mapToGlobal(QPoint((parts_.window.width() - palette->width()) / 2, 64)));
  palette->show();
}

void HelpFlow::showAbout() {
  QMessageBox::about(&parts_.window, tr("About Espalier"),
                     tr("<b>Espalier %1</b><br>From a laser scan of a plant to a skeleton an "
                        "expert would sign.")
                         .arg(QCoreApplication::applicationVersion()));
}

} // namespace espalier
