#include "app/window/edit/stand_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "ui/document/plant_document.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/tools/tool.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QActionGroup>

#include <array>
#include <utility>

namespace espalier {
namespace {

constexpr std::array<std::pair<UpAxis, const char*>, 3> upAxes{
    {{UpAxis::x, "x"}, {UpAxis::y, "y"}, {UpAxis::z, "z"}}};

QString idOf(const char* axis) {
  return QStringLiteral("up_") + QLatin1String(axis);
}

} // namespace

StandFlow::StandFlow(const Parts& parts) : parts_(parts) {
  addActions();
  connect(&parts_.document, &PlantDocument::upChanged, this, &StandFlow::showUp);
  connect(&parts_.document, &PlantDocument::rootChanged, this, &StandFlow::showRoot);
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::skeletonReplaced})
    connect(&parts_.document, signal, this, &StandFlow::refresh);
  connect(&parts_.document, &PlantDocument::skeletonEdited, this, &StandFlow::refresh);
  connect(&parts_.editing.toolNamed("root"), &Tool::finished, this, &StandFlow::noteRoot);
  connect(&parts_.pipeline, &PipelinePanel::rootAsked, parts_.actions["tool_root"],
          &QAction::trigger);
  refresh();
}

void StandFlow::addActions() {
  parts_.actions.beginSection(tr("Root and Up"));
  parts_.actions.add(
      {.id = "root_lowest",
       .text = tr("Root at the Lowest Point"),
       .help = tr("Forgets the root that was picked: it is where the scan is lowest"),
       .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R)},
      [this] {
        parts_.document.setRoot(std::nullopt);
        noteRoot();
      });
  parts_.actions.place("skeleton/stand", {"tool_root", "root_lowest", ""});
  auto* group = new QActionGroup(this);
  for (const auto& [axis, name] : upAxes) {
    const auto choose = [this, up = axis] { parts_.document.setUp(up); };
    group->addAction(parts_.actions.add(
        {.id = idOf(name),
         .text = tr("Up Is %1").arg(QLatin1String(name)),
         .help = tr("The %1 axis of the file points up: the plant stands along it")
                     .arg(QLatin1String(name)),
         .isCheckable = true,
         .menu = "skeleton/stand"},
        choose));
  }
}

void StandFlow::showUp() {
  parts_.view.setUp(parts_.document.up());
  parts_.view.faceAll();
  refresh();
}

void StandFlow::showRoot() {
  parts_.view.setRootMark(parts_.document.root());
  refresh();
}

void StandFlow::noteRoot() {
  emit noted(parts_.document.root() ? tr("Root picked: reconstruct to grow the plant from there")
                                    : tr("The root is where the scan is lowest"));
}

void StandFlow::refresh() {
  parts_.actions["root_lowest"]->setEnabled(parts_.document.root().has_value());
  for (const auto& [axis, name] : upAxes) {
    parts_.actions[idOf(name)]->setEnabled(!parts_.document.isEmpty());
    parts_.actions[idOf(name)]->setChecked(axis == parts_.document.up());
  }
}

} // namespace espalier
