#include "app/window/unit_flow.h"

#include "app/window/action_set.h"
#include "ui/dialogs/commit_marks_dialog.h"
#include "ui/panels/inspector_panel.h"

#include <QAction>

namespace espalier {

UnitFlow::UnitFlow(PlantDocument& document, ActionSet& actions, InspectorPanel& inspector,
                   QWidget& window)
    : document_(document), actions_(actions), window_(window) {
  actions_.beginSection(tr("Units"));
  actions_.add({.id = "commit_marks",
                .text = tr("Commit Marks to a Scale…"),
                .help = tr("Makes units of a new scale, one from each mark")},
               [this] { commit(); });
  actions_.add({.id = "clear_marks",
                .text = tr("Clear Marks"),
                .help = tr("Takes all marks of unit starts off")},
               [this] { clear(); });
  connect(&inspector, &InspectorPanel::unitTyped, this, &UnitFlow::edit);
  connect(&document_, &PlantDocument::skeletonEdited, this, &UnitFlow::count);
  connect(&document_, &PlantDocument::skeletonReplaced, this,
          [this] { setMarks(markedNodes(document_.skeleton()).size()); });
  refreshEnabled();
}

void UnitFlow::setEnabled(bool isEnabled) {
  isEnabled_ = isEnabled;
  refreshEnabled();
}

void UnitFlow::commit() {
  CommitMarksDialog dialog(document_, &window_);
  connect(&dialog, &CommitMarksDialog::commitRequested, this, [&](const NewScale& scale) {
    const auto& frame = document_.structure().frame;
    const QString name = tr("Commit the marks to %1").arg(QString::fromStdString(scale.symbol));
    const auto change = [&](SkeletonEditor& editor) {
      commitMarks(editor, scale, frame ? &frame->mtg : nullptr);
    };
    if (edit(name, change, dialog.symbolField())) dialog.accept();
  });
  dialog.exec();
}

void UnitFlow::clear() {
  document_.edit(tr("Clear the marks"), [](SkeletonEditor& editor) { clearMarks(editor); });
}

bool UnitFlow::edit(const QString& name, const std::function<void(SkeletonEditor&)>& change,
                    QWidget* field) {
  field_ = field;
  const auto act = [&] {
    document_.edit(name, change);
    return true;
  };
  return actions_.guarded(act, Refusal::atField);
}

void UnitFlow::count(const SkeletonDelta& delta) {
  std::size_t marks = marks_;
  for (const SkeletonDelta::Change& change : delta.changes) {
    if (change.before && change.before->isMarked) --marks;
    if (change.after && change.after->isMarked) ++marks;
  }
  setMarks(marks);
}

void UnitFlow::setMarks(std::size_t marks) {
  if (marks == marks_) return;
  marks_ = marks;
  refreshEnabled();
  emit marksChanged();
}

void UnitFlow::refreshEnabled() {
  for (const char* id : {"commit_marks", "clear_marks"})
    actions_[id]->setEnabled(isEnabled_ && marks_ > 0);
}

} // namespace espalier
