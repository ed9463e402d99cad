// The commands of the File menu.
#include "app/window/files/file_flow.h"
#include "app/window/files/recent_files.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/menu_letters.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "ui/document/plant_document.h"

#include <QAction>
#include <QDir>
#include <QMenu>

namespace espalier {

void FileFlow::addActions() {
  ActionSet& actions = parts_.actions;
  actions.beginSection(tr("File"));
  actions.add({.id = "open",
               .text = tr("&Open…"),
               .help = tr("Opens a scan, or a skeleton over it"),
               .icon = "open",
               .keys = QKeySequence::Open,
               .menu = "file/open"},
              [this] { chooseAndOpen(Asking::ifUnclear); });
  actions.add({.id = "open_with_choices",
               .text = tr("Open &With Choices…"),
               .help = tr("Shows what is in a scan before it is read, and lets you choose columns, "
                          "unit, up axis and how much of it to read"),
               .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_O),
               .menu = "file/open"},
              [this] { chooseAndOpen(Asking::always); });
  actions.add({.id = "read_region",
               .text = tr("Read the Re&gion in Full"),
               .help = tr("Of a scan that is shown in part, reads all points that lie in the box "
                          "the view is clipped to, as a plant of its own"),
               .menu = "file/open"},
              [this] { openRegion(); });
  actions["read_region"]->setEnabled(false);
  actions.place("file/recent", [this](QMenu& menu) {
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { fillRecent(menu); });
  });
  actions.add({.id = "save",
               .text = tr("&Save"),
               .help = tr("Saves the skeleton"),
               .icon = "save",
               .keys = QKeySequence::Save,
               .menu = "file/save"},
              [this] { save(); });
  actions.add({.id = "save_as",
               .text = tr("Save &As…"),
               .help = tr("Saves the skeleton under another name"),
               .icon = "save_as",
               .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
               .menu = "file/save"},
              [this] { saveAs(); });
  actions.add({.id = "close_plant",
               .text = tr("&Close Plant"),
               .help = tr("Puts scan and skeleton away"),
               .keys = QKeySequence(Qt::CTRL | Qt::Key_W),
               .menu = "file/close"},
              [this] { closePlant(); });
  actions.add({.id = "quit",
               .text = tr("&Quit"),
               .help = tr("Leaves the program"),
               .keys = QKeySequence(Qt::CTRL | Qt::Key_Q),
               .menu = "file/close"},
              [this] { parts_.window.close(); });
}

void FileFlow::addProjectActions() {
  ActionSet& actions = parts_.actions;
  actions.add({.id = "new_plant",
               .text = tr("&New"),
               .help = tr("Puts this plant away and begins another"),
               .keys = QKeySequence::New,
               .menu = "file/new"},
              [this] { closePlant(); });
  actions.add({.id = "save_project_as",
               .text = tr("Save &Project As…"),
               .help = tr("Keeps plant, scan and history in one file, which saves itself"),
               .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S),
               .menu = "file/save"},
              [this] { parts_.projects.saveAs(); });
  actions.add({.id = "keep_scan",
               .text = tr("Keep the Scan in the Project"),
               .help = tr("Writes the scan into the project file, which then needs no other"),
               .isCheckable = true,
               .menu = "file/project"},
              [this] {
                refreshProject(); // it is checked once it is done
                parts_.projects.keepScan(!parts_.projects.isScanKept());
              });
  actions.add({.id = "compact_project",
               .text = tr("Compact Project"),
               .help = tr("Gives back the room that the project file no longer uses"),
               .menu = "file/project"},
              [this] { parts_.projects.compact(); });
  actions.add({.id = "export_structure",
               .text = tr("&Export Structure…"),
               .help = tr("Writes a copy of the skeleton, as MTG or another format"),
               .keys = QKeySequence(Qt::CTRL | Qt::Key_E),
               .menu = "file/export"},
              [this] { exportStructure(); });
  for (auto signal : {&PlantDocument::titleChanged, &PlantDocument::scanChanged})
    connect(&parts_.document, signal, this, &FileFlow::refreshProject);
}

void FileFlow::setPlantShown(bool /*isShown*/) {
  const PlantDocument& document = parts_.document;
  const bool isShapeless = isWithoutPositions(document.structure());
  for (const char* id : {"save", "save_as", "export_structure"})
    parts_.actions[id]->setEnabled(isShapeless || !document.skeleton().isEmpty());
  parts_.actions["save_project_as"]->setEnabled(isShapeless || !document.isEmpty());
  refreshProject();
}

void FileFlow::refreshProject() {
  const ProjectFlow& projects = parts_.projects;
  parts_.actions["compact_project"]->setEnabled(projects.isNamed());
  parts_.actions["keep_scan"]->setEnabled(projects.isNamed() && parts_.document.scan() != nullptr);
  parts_.actions["keep_scan"]->setChecked(projects.isScanKept());
}

void FileFlow::fillRecent(QMenu& menu) {
  menu.clear();
  for (const QString& path : parts_.recent.paths())
    menu.addAction(entryText(QDir::toNativeSeparators(path)), this, [this, path] {
      parts_.actions.guarded(
          [&] {
            open({path});
            return true;
          },
          Refusal::inBanner);
    });
  if (menu.isEmpty())
    menu.addAction(tr("None yet"))->setEnabled(false);
  else
    menu.addSeparator();
  menu.addAction(tr("Clear"), &parts_.recent, &RecentFiles::clear);
}

} // namespace espalier
