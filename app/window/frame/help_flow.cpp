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
#include "ui/document/manual_place.h"
#include "ui/document/shown_text.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QKeyEvent>

namespace espalier {
namespace {

QString resource(const QString& name) {
  QFile file(name);
  const bool isThere = file.open(QIODevice::ReadOnly);
  Q_ASSERT(isThere);
  return isThere ? QString::fromUtf8(file.readAll()) : QString();
}

/// The license, and the notices of what is compiled in.
AboutDialog::About about() {
  AboutDialog::About all = {.icon = programIcon(),
                            .version = QString::fromStdString(programVersion()),
                            .libraries = {},
                            .license = resource(":/LICENSE") + '\n' + resource(":/NOTICES")};
  for (const Library& library : libraries())
    all.libraries.append({QString::fromStdString(library.name),
                          QString::fromStdString(library.version),
                          QString::fromStdString(library.license), shownText(library.use)});
  return all;
}

} // namespace

HelpFlow::HelpFlow(const Parts& parts) : parts_(parts) {
  addActions();
  parts_.actions.place("help", {"manual", "tour", "shortcuts", "palette", "", "about"});
  keys_ = new KeyBindings(parts_.actions.all(), {"leave", "accept"}, parts_.settings, this);
  connect(keys_, &KeyBindings::changed, this, &HelpFlow::hintChanged);
  qApp->installEventFilter(this);
}

HelpFlow::~HelpFlow() = default;

QString HelpFlow::manualPlace() const {
  const QWidget* dialog = QApplication::activeModalWidget();
  const QWidget* in = dialog != nullptr ? dialog : QApplication::focusWidget();
  if (const QString place = manualPlaceOf(in); !place.isEmpty()) return place;
  return parts_.placeOfTool();
}

bool HelpFlow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || !watched->isWidgetType()) return false;
  const auto& widget = static_cast<const QWidget&>(*watched);
  const auto& keys = static_cast<const QKeyEvent&>(*event);
  if (widget.window() == &parts_.window || manualPlaceOf(&widget).isEmpty() ||
      !parts_.actions["manual"]->shortcuts().contains(QKeySequence(keys.keyCombination())))
    return false;
  showManual();
  return true;
}

void HelpFlow::showManual() {
  const QString place = manualPlace();
  QWidget* dialog = QApplication::activeModalWidget();
  // Beside a dialog that takes all keys, only what belongs to it can be used.
  if (manual_ != nullptr && dialog != nullptr && manual_->parentWidget() != dialog) delete manual_;
  if (manual_ == nullptr) manual_ = new ManualWindow(dialog != nullptr ? dialog : &parts_.window);
  manual_->show();
  manual_->raise();
  manual_->activateWindow();
  manual_->goTo(place);
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
               .help = tr("Opens at the chapter of the panel, tool or dialog that you are in"),
               .icon = "info",
               .keys = QKeySequence(Qt::Key_F1)},
              [this] { showManual(); });
  actions.add({.id = "shortcuts",
               .text = tr("Shortcuts"),
               .help = tr("Shows all keys on one sheet"),
               .icon = "keyboard",
               .keys = QKeySequence(Qt::Key_Question)},
              [this] {
                emit keysAsked();
                (new ShortcutSheet(*keys_, &parts_.window))->show();
              });
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
