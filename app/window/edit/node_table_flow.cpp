#include "app/window/edit/node_table_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/skeleton/edits.h"
#include "ui/document/plant_document.h"
#include "ui/panels/node_table_model.h"
#include "ui/panels/node_table_panel.h"
#include "ui/tools/node_edits.h"

#include <QApplication>
#include <QClipboard>

namespace espalier {

NodeTableFlow::NodeTableFlow(const Parts& parts)
    : parts_(parts), panel_(new NodeTablePanel(parts.document)) {
  parts_.window.actions.beginSection(tr("Edit"));
  parts_.window.actions.add(
      {.id = "copy",
       .text = tr("&Copy"),
       .help = tr("Copies the selected nodes as a table, or what was measured"),
       .keys = QKeySequence::Copy,
       .refusal = Refusal::atPointer,
       .menu = "edit/copy"},
      [this] { copy(); });
  parts_.window.actions.beginSection(tr("View"));
  addDock(new PanelDock(parts_.window,
                        {.id = "node_table",
                         .title = tr("Node Table"),
                         .text = tr("Node Table"),
                         .help = tr("Shows or hides the table of nodes"),
                         .keys = Qt::Key_F11,
                         .manual = "window.md#the-table-of-nodes"},
                        {.size = 300}, panel_, this)); // some rows below its fields
  connectTable();
}

void NodeTableFlow::connectTable() {
  NodeTableModel& model = panel_->model();
  connect(panel_, &NodeTablePanel::copyRequested, this,
          [this] { guarded([this] { copyTable(); }); });
  connect(&model, &NodeTableModel::radiusTyped, this, [this](NodeId id, double radius) {
    guarded([&] { setRadius(parts_.document, {id}, radius); });
  });
  connect(&model, &NodeTableModel::edgeChosen, this, [this](NodeId id, EdgeType type) {
    const QString text =
        type == EdgeType::successor ? tr("Make %1 axial") : tr("Make %1 branching");
    guarded([&] {
      parts_.document.edit(text.arg(nodeName(id)),
                           [=](SkeletonEditor& editor) { setEdgeType(editor, id, type); });
    });
  });
  connect(&model, &NodeTableModel::refused, this,
          [this](const QString& reason) { guarded([&] { throw Error(reason.toStdString()); }); });
}

void NodeTableFlow::guarded(const std::function<void()>& act) {
  parts_.window.actions.guarded(
      [&] {
        act();
        return true;
      },
      Refusal::inBanner);
}

/// What one sees as chosen: rows where the table has the keyboard, else the nodes in the view.
void NodeTableFlow::copy() {
  if (panel_->isAncestorOf(QApplication::focusWidget())) return copyTable();
  if (const QString measured = parts_.editing.result(); !measured.isEmpty()) {
    QApplication::clipboard()->setText(measured);
    return emit noted(tr("Copied: %1").arg(measured));
  }
  const std::vector<NodeId>& nodes = parts_.document.selection().nodes();
  if (nodes.empty()) throw Error(tr("select the nodes to copy first").toStdString());
  panel_->model().update();
  QApplication::clipboard()->setText(panel_->model().tableOf(nodes));
  emit noted(tr("Copied %1 as a table").arg(nodeNames(nodes)));
}

void NodeTableFlow::copyTable() {
  const QString table = panel_->table();
  QApplication::clipboard()->setText(table);
  const int rows = static_cast<int>(table.count('\n')) - 1;
  emit noted(rows == 1 ? tr("Copied 1 row") : tr("Copied %n rows", nullptr, rows));
}

} // namespace espalier
