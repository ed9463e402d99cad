#include "app/window/frame/help_flow.h"

#include "app/about/libraries.h"
#include "app/about/version.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/icon.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/command_palette.h"
#include "ui/dialogs/key_bindings.h"
#include "ui/dialogs/manual_window.h"
#include "ui/dialogs/shortcut_sheet.h"
#include "ui/document/shown_text.h"

#include <QFile>

namespace espalier {
namespace {

AboutDialog::About about() {
  QFile license(":/LICENSE");
  const bool isThere = license.open(QIODevice::ReadOnly);
  Q_ASSERT(isThere);
  AboutDialog::About all = {.icon = programIcon(),
                            .version = QString::fromStdString(programVersion()),
                            .libraries = {},
                            .license = isThere ? QString::fromUtf8(license.readAll()) : QString()};
  for (const Library& library : libraries())
    all.libraries.append({QString::fromStdString(library.name),
                          QString::fromStdString(library.version),
                          QString::fromStdString(library.license), shownText(library.use)});
  return all;
}

} // namespace

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
  actions.add({.id = "about",
               .text = tr("About Espalier"),
               .help = tr("Its version and license, and those of all libraries")},
              [this] { (new AboutDialog(about(), &parts_.window))->show(); });
}

void HelpFlow::showPalette() {
  auto* palette = new CommandPalette(parts_.actions.all(), &parts_.window);
  palette->move(
      parts_.window.mapToGlobal(QPoint((parts_.window.width() - palette->width()) / 2, 64)));
  palette->show();
}

} // namespace espalier
