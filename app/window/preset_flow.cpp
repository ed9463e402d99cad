#include "app/window/preset_flow.h"

#include "app/window/action_set.h"
#include "app/window/load_files.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/pipeline/preset.h"
#include "core/pipeline/presets.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

#include <fstream>

namespace espalier {
namespace {

const QString folderKey = QStringLiteral("preset_folder");

QString idOf(const NamedPreset& preset) {
  return "preset_" + QString::fromStdString(preset.name);
}

} // namespace

PresetFlow::PresetFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("Settings of the Steps"));
  for (const NamedPreset& preset : presets())
    parts_.actions.add({.id = idOf(preset),
                        .text = tr("Settings: %1").arg(QString::fromStdString(preset.label)),
                        .help = QString::fromStdString(preset.help)},
                       [this, &preset] {
                         parts_.pipeline.setOptions(preset.options);
                         emit chosen();
                       });
  parts_.actions.add({.id = "open_preset",
                      .text = tr("Open Settings…"),
                      .help = tr("Takes methods and options of all steps from a file")},
                     [this] { open(); });
  parts_.actions.add({.id = "save_preset",
                      .text = tr("Save Settings…"),
                      .help = tr("Writes methods and options of all steps to a file, for other "
                                 "plants and for the command line")},
                     [this] { save(); });
}

void PresetFlow::fillMenu(QMenu& menu) const {
  for (const NamedPreset& preset : presets())
    menu.addAction(parts_.actions[idOf(preset)]);
  menu.addSeparator();
  for (const char* id : {"open_preset", "save_preset"})
    menu.addAction(parts_.actions[id]);
}

void PresetFlow::open() {
  const QString path = QFileDialog::getOpenFileName(&parts_.window, tr("Open settings"),
                                                    parts_.settings.value(folderKey).toString(),
                                                    tr("Settings (*.json)"));
  if (path.isEmpty()) return;
  std::ifstream in(toPath(path));
  if (!in)
    throw Error(tr("%1 cannot be read: check your rights to it")
                    .arg(QFileInfo(path).fileName())
                    .toStdString());
  const PipelineOptions options = readPreset(in, QFileInfo(path).fileName().toStdString());
  parts_.settings.setValue(folderKey, QFileInfo(path).absolutePath());
  parts_.pipeline.setOptions(options);
  emit chosen();
}

void PresetFlow::save() {
  QFileDialog dialog(&parts_.window, tr("Save settings"),
                     parts_.settings.value(folderKey).toString(), tr("Settings (*.json)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("json");
  dialog.selectFile("settings.json");
  if (dialog.exec() != QDialog::Accepted) return;
  const QString path = dialog.selectedFiles().front();
  writeAtomically(toPath(path),
                  [this](std::ostream& out) { writePreset(out, parts_.pipeline.options()); });
  parts_.settings.setValue(folderKey, QFileInfo(path).absolutePath());
  parts_.banner.showResult(tr("Wrote %1").arg(QFileInfo(path).fileName()));
}

} // namespace espalier
