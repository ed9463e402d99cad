#include "app/window/edit/snap_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"

#include <QAction>
#include <QActionGroup>
#include <QSettings>

#include <array>

namespace espalier {
namespace {

QString idOf(Snap snap) {
  switch (snap) {
  case Snap::nothing:
    return QStringLiteral("snap_off");
  case Snap::contracted:
    return QStringLiteral("snap_contracted");
  case Snap::section:
    return QStringLiteral("snap_section");
  }
  return {};
}

constexpr auto setting = "tools/snap";
constexpr std::array snaps = {Snap::nothing, Snap::contracted, Snap::section};

} // namespace

SnapFlow::SnapFlow(PlantDocument& document, ActionSet& actions, const Editing& editing,
                   QSettings& settings)
    : document_(document), actions_(actions), settings_(settings),
      tool_(qobject_cast<MoveNodeTool*>(&editing.toolNamed("move"))) {
  Q_ASSERT(tool_ != nullptr);
  actions_.beginSection(tr("Tools"));
  auto* group = new QActionGroup(this);
  const auto add = [&](Snap snap, const QString& text, const QString& help) {
    group->addAction(actions_.add({.id = idOf(snap),
                                   .text = text,
                                   .help = help,
                                   .isCheckable = true,
                                   .refusal = Refusal::atPointer,
                                   .menu = "edit/snap"},
                                  [this, snap] { choose(snap); }));
  };
  add(Snap::nothing, tr("Snap to Nothing"),
      tr("A node that is dragged follows the pointer; with Ctrl it snaps to its section"));
  add(Snap::contracted, tr("Snap to Contracted Points"),
      tr("A node that is dragged lies on the contracted points, unless Ctrl is held"));
  add(Snap::section, tr("Snap to Section Center"),
      tr("A node that is dragged lies in the middle of the wood around it, unless Ctrl is held"));
  for (const Snap snap : snaps) // without a scan yet it moves nodes freely
    if (settings_.value(setting) == idOf(snap)) tool_->setSnap(snap);
  showChoice();
}

void SnapFlow::choose(Snap snap) {
  const bool isMissing = (snap == Snap::contracted && !document_.contracted()) ||
                         (snap == Snap::section && document_.scan() == nullptr);
  if (!isMissing) {
    tool_->setSnap(snap);
    settings_.setValue(setting, idOf(snap));
  }
  showChoice();
  if (isMissing)
    throw Error((snap == Snap::section
                     ? tr("there are no points to snap to: open the scan first")
                     : tr("there are no contracted points to snap to: reconstruct first"))
                    .toStdString());
}

void SnapFlow::showChoice() {
  actions_[idOf(tool_->snap())]->setChecked(true);
}

} // namespace espalier
