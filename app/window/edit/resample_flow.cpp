#include "app/window/edit/resample_flow.h"

#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "ui/tools/structure_edits.h"

#include <QApplication>
#include <QInputDialog>

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

/// Enough decimals for three digits of a length.
int decimalsOf(double length) {
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(length))), 0, 9);
}

} // namespace

ResampleFlow::ResampleFlow(PlantDocument& document, ActionSet& actions, Nodes nodes,
                           QObject* parent)
    : QObject(parent), document_(document) {
  actions.add({.id = "resample",
               .text = tr("Resample to Length…"),
               .help = tr("Spaces nodes evenly, by a length of edges that you type"),
               .refusal = Refusal::atPointer},
              [this, nodes = std::move(nodes)] { ask(nodes()); });
}

void ResampleFlow::ask(const std::vector<NodeId>& nodes) {
  const double spacing = pathSpacing(document_.skeleton(), nodes);
  if (spacing == 0) throw Error(tr("there is no edge between the ends").toStdString());
  QInputDialog dialog(QApplication::activeWindow());
  dialog.setInputMode(QInputDialog::DoubleInput);
  dialog.setWindowTitle(tr("Resample to Length"));
  const QString unit = symbol(document_.unit());
  dialog.setLabelText(unit.isEmpty() ? tr("Length of edges")
                                     : tr("Length of edges [%1]").arg(unit));
  dialog.setDoubleDecimals(decimalsOf(spacing));
  dialog.setDoubleRange(spacing / 1000, spacing * 1000);
  dialog.setDoubleStep(spacing / 10);
  dialog.setDoubleValue(spacing);
  dialog.setOkButtonText(tr("Resample"));
  if (dialog.exec() == QDialog::Accepted) resamplePath(document_, nodes, dialog.doubleValue());
}

} // namespace espalier
