#include "app/window/preview/preset_flow.h"

#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/menu_letters.h"
#include "app/window/preview/options_text.h"
#include "core/base/error.h"
#include "core/base/open_for_reading.h"
#include "core/io/atomic_file.h"
#include "core/pipeline/preset.h"
#include "core/pipeline/presets.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_text.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QSettings>

#include <algorithm>
#include <sstream>

namespace espalier {
namespace {

const QString presetFolderKey = QStringLiteral("preset_folder");
const QString ownKey = QStringLiteral("own_presets");

QString idOf(const NamedPreset& preset) {
  return "preset_" + QString::fromStdString(preset.name);
}

} // namespace

PresetFlow::PresetFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("Settings of the Steps"));
  for (const NamedPreset& preset : presets())
    parts_.actions.add({.id = idOf(preset),
                        .text = tr("Settings: %1").arg(shownText(preset.label)),
                        .help = shownText(preset.help)},
                       [this, &preset] { take(preset.options, shownText(preset.label)); });
  parts_.actions.add({.id = "keep_preset",
                      .text = tr("Keep Settings As…"),
                      .help = tr("Keeps methods and options of all steps under a name in this "
                                 "menu")},
                     [this] { keep(); });
  parts_.actions.add({.id = "open_preset",
                      .text = tr("Open Settings…"),
                      .help = tr("Takes methods and options of all steps from a file")},
                     [this] { open(); });
  parts_.actions.add({.id = "save_preset",
                      .text = tr("Save Settings…"),
                      .help = tr("Writes methods and options of all steps to a file, for other "
                                 "plants and for the command line")},
                     [this] { save(); });
  parts_.actions.place("skeleton/settings", [this](QMenu& menu) {
    menu.setObjectName("presets");
    fill(menu); // for who looks through the menus
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { fill(menu); });
  });
}

void PresetFlow::fill(QMenu& menu) {
  menu.clear();
  for (const NamedPreset& preset : presets())
    menu.addAction(parts_.actions[idOf(preset)]);
  const std::vector<Own> kept = own();
  for (const Own& each : kept)
    menu.addAction(tr("Settings: %1").arg(entryText(each.name)), this, [this, each] {
      std::istringstream in(each.text);
      take(readPreset(in, each.name.toStdString(), metersIn(parts_.document.unit())), each.name);
    });
  menu.addSeparator();
  for (const char* id : {"keep_preset", "open_preset", "save_preset"})
    menu.addAction(parts_.actions[id]);
  if (kept.empty()) return;
  menu.addSeparator();
  QMenu* removal = menu.addMenu(tr("Forget"));
  for (const Own& each : kept)
    removal->addAction(entryText(each.name), this, [this, name = each.name] { forget(name); });
}

std::vector<PresetFlow::Own> PresetFlow::own() const {
  std::vector<Own> all;
  const int count = parts_.settings.beginReadArray(ownKey);
  for (int i = 0; i < count; ++i) {
    parts_.settings.setArrayIndex(i);
    all.push_back({.name = parts_.settings.value("name").toString(),
                   .text = parts_.settings.value("settings").toString().toStdString()});
  }
  parts_.settings.endArray();
  return all;
}

void PresetFlow::setOwn(const std::vector<Own>& all) {
  parts_.settings.remove(ownKey);
  parts_.settings.beginWriteArray(ownKey, static_cast<int>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    parts_.settings.setArrayIndex(static_cast<int>(i));
    parts_.settings.setValue("name", all[i].name);
    parts_.settings.setValue("settings", QString::fromStdString(all[i].text));
  }
  parts_.settings.endArray();
}

void PresetFlow::keep() {
  QInputDialog dialog(&parts_.window);
  dialog.setWindowTitle(tr("Keep Settings"));
  dialog.setLabelText(tr("Name, in the menu Settings of the Steps:"));
  dialog.setOkButtonText(tr("Keep"));
  if (dialog.exec() != QDialog::Accepted) return;
  const QString name = dialog.textValue().simplified();
  if (name.isEmpty()) return;
  std::ostringstream text;
  write(text);
  std::vector<Own> all = own();
  const auto before = std::ranges::find(all, name, &Own::name);
  if (before != all.end())
    before->text = text.str();
  else
    all.push_back({.name = name, .text = text.str()});
  setOwn(all);
  emit reported({.text = tr("Kept these settings as %1").arg(name)});
}

void PresetFlow::forget(const QString& name) {
  std::vector<Own> all = own();
  std::erase_if(all, [&](const Own& each) { return each.name == name; });
  setOwn(all);
}

void PresetFlow::take(const PipelineOptions& options, const QString& name) {
  const PipelineOptions before = parts_.pipeline.options();
  show(options);
  const PipelineOptions now = parts_.pipeline.options();
  const QString taken = tr("Settings: %1").arg(name);
  const bool replacesSome = !before.settings.empty() || !before.methods.empty();
  const QString change =
      shortChangeText(before, now, parts_.document.scale(), symbol(parts_.document.unit()), 250);
  if (!replacesSome || change.isEmpty()) return void(emit noted(taken));
  emit reported({.text = tr("%1. What is set otherwise now: %2").arg(taken, change),
                 .actions = {{tr("Take Back"), [this, before] { show(before); }}}});
}

void PresetFlow::show(const PipelineOptions& options) {
  parts_.pipeline.setOptions(options);
  emit chosen();
  emit keptChanged();
}

void PresetFlow::write(std::ostream& out) const {
  writePreset(out, parts_.pipeline.options(), symbol(parts_.document.unit()).toStdString());
}

void PresetFlow::open() {
  const QString path = QFileDialog::getOpenFileName(
      &parts_.window, tr("Open settings"), parts_.settings.value(presetFolderKey).toString(),
      tr("Settings (*.json)"));
  if (path.isEmpty()) return;
  std::istringstream in(readText(toPath(path)));
  const PipelineOptions options =
      readPreset(in, QFileInfo(path).fileName().toStdString(), metersIn(parts_.document.unit()));
  parts_.settings.setValue(presetFolderKey, QFileInfo(path).absolutePath());
  take(options, QFileInfo(path).fileName());
}

void PresetFlow::save() {
  QFileDialog dialog(&parts_.window, tr("Save settings"),
                     parts_.settings.value(presetFolderKey).toString(), tr("Settings (*.json)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("json");
  dialog.selectFile("settings.json");
  if (dialog.exec() != QDialog::Accepted) return;
  const QString path = dialog.selectedFiles().front();
  writeAtomically(toPath(path), [this](std::ostream& out) { write(out); });
  parts_.settings.setValue(presetFolderKey, QFileInfo(path).absolutePath());
  emit reported({.text = tr("Wrote %1").arg(QFileInfo(path).fileName())});
}

} // namespace espalier
