#include "app/window/view/saved_views.h"

#include "app/window/frame/action_set.h"
#include "app/window/frame/menu_letters.h"
#include "app/window/view/shown_flow.h"
#include "app/window/view/view_options.h"
#include "ui/view/plant_view.h"

#include <QInputDialog>
#include <QMenu>

#include <algorithm>

namespace espalier {

SavedViews::SavedViews(const Parts& parts)
    : view_(parts.view), options_(parts.options), shown_(parts.shown), actions_(parts.actions),
      window_(parts.window) {
  actions_.beginSection(tr("View"));
  actions_.add({.id = "save_view",
                .text = tr("Save This View…"),
                .help = tr("Keeps camera, clipping and what is hidden, under a name")},
               [this] { save(); });
  actions_.place("view/saved", [this](QMenu& menu) {
    menu.setObjectName("saved_views");
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { fill(menu); });
  });
}

void SavedViews::fill(QMenu& menu) {
  menu.clear();
  menu.addAction(actions_["save_view"]);
  if (options_.savedViews().empty()) return;
  menu.addSeparator();
  for (const SavedView& saved : options_.savedViews())
    menu.addAction(entryText(saved.name), this, [this, saved] { show(saved); });
  menu.addSeparator();
  QMenu* removal = menu.addMenu(tr("Remove"));
  for (const SavedView& saved : options_.savedViews())
    removal->addAction(entryText(saved.name), this, [this, name = saved.name] { remove(name); });
}

void SavedViews::save() {
  std::vector<SavedView> all = options_.savedViews();
  const auto named = [&](const QString& name) {
    return std::ranges::find(all, name, &SavedView::name);
  };
  QString proposed;
  for (int number = 1; proposed.isEmpty() || named(proposed) != all.end(); ++number)
    proposed = tr("View %1").arg(number);
  QInputDialog dialog(&window_);
  dialog.setWindowTitle(tr("Save This View"));
  dialog.setLabelText(tr("Name:"));
  dialog.setTextValue(proposed);
  dialog.setOkButtonText(tr("Save"));
  if (dialog.exec() != QDialog::Accepted) return;
  const QString name = dialog.textValue().simplified();
  if (name.isEmpty()) return;
  const SavedView saved{.name = name,
                        .camera = view_.camera(),
                        .clip = view_.clip(),
                        .depthFade = view_.depthFade(),
                        .hidden = shown_.hidden()};
  if (const auto before = named(name); before != all.end())
    *before = saved;
  else
    all.push_back(saved);
  options_.setSavedViews(std::move(all));
  emit keptChanged();
}

void SavedViews::show(const SavedView& saved) {
  view_.setClip(saved.clip);
  view_.setDepthFade(saved.depthFade);
  shown_.setHidden(saved.hidden);
  shown_.refreshPanel();
  view_.flyTo(saved.camera);
}

void SavedViews::remove(const QString& name) {
  std::vector<SavedView> all = options_.savedViews();
  std::erase_if(all, [&](const SavedView& saved) { return saved.name == name; });
  options_.setSavedViews(std::move(all));
  emit keptChanged();
}

} // namespace espalier
