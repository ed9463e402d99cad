#include "app/window/edit/unit_flow.h"

#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "core/mtg/feature_edits.h"
#include "core/mtg/unit_edits.h"
#include "core/mtg/unit_scales.h"
#include "ui/dialogs/add_value_dialog.h"
#include "ui/dialogs/commit_marks_dialog.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/unit_rows.h"

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
  actions_.place("skeleton/units", {"mark_unit_start", "commit_marks", "clear_marks"});
  connect(&inspector, &InspectorPanel::unitTyped, this, &UnitFlow::edit);
  connect(&inspector, &InspectorPanel::featureRequested, this, &UnitFlow::addFeature);
  connect(&inspector, &InspectorPanel::dateRequested, this, &UnitFlow::addDate);
  connect(&document_, &PlantDocument::skeletonEdited, this, &UnitFlow::recount);
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

void UnitFlow::addFeature(const UnitPart& part) {
  AddValueDialog dialog(tr("Add a Feature to %1").arg(part.name), {}, &window_);
  connect(&dialog, &AddValueDialog::addRequested, this, [&](const TypedFeature& typed) {
    const Mtg* base = baseOf(document_);
    const QString feature = QString::fromStdString(typed.feature.name).trimmed();
    const auto change = [&](SkeletonEditor& editor) {
      requireNewFeature(editor.skeleton(), typed.feature.name, base);
      actions_.setField(dialog.valueField()); // the name is as it should be
      if (hasEntities(editor.skeleton()))
        espalier::addFeature(editor, part.start, part.scale, typed, base);
      else
        setNodeFeature(editor, part.start, typed, base);
    };
    if (edit(tr("Add the feature %1 to %2").arg(feature, part.name), change, dialog.nameField()))
      dialog.accept();
  });
  dialog.exec();
}

void UnitFlow::addDate(const UnitPart& part) {
  const Mtg* base = baseOf(document_);
  const Skeleton& skeleton = document_.skeleton();
  const Entity entity = entityAt(skeleton, part.start, part.scale);
  const std::size_t date = entity.later.size();
  AddValueDialog dialog(tr("Add a Date to %1").arg(part.name),
                        typedFeaturesLater(entity, date, base, addedFeatures(skeleton, base)),
                        &window_);
  connect(&dialog, &AddValueDialog::addRequested, this, [&](const TypedFeature& typed) {
    const auto change = [&](SkeletonEditor& editor) {
      setFeature(editor, part.start, part.scale, {typed.feature, typed.text, date}, base);
    };
    if (edit(tr("Add a date to %1").arg(part.name), change, dialog.valueField())) dialog.accept();
  });
  dialog.exec();
}

bool UnitFlow::edit(const QString& name, const std::function<void(SkeletonEditor&)>& change,
                    QWidget* field) {
  actions_.setField(field);
  const auto act = [&] {
    document_.edit(name, change);
    return true;
  };
  return actions_.guarded(act, Refusal::atField);
}

void UnitFlow::recount(const SkeletonDelta& delta) {
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
  emit countChanged();
  emit hintChanged();
}

QString UnitFlow::furtherHint() const {
  return marks_ > 0 ? withKeys(tr("{mark_unit_start} mark unit start"), actions_) : QString();
}

QString UnitFlow::count() const {
  return marks_ > 0 ? tr("%1 marked").arg(formatCount(marks_)) : QString();
}

void UnitFlow::refreshEnabled() {
  for (const char* id : {"commit_marks", "clear_marks"})
    actions_[id]->setEnabled(isEnabled_ && marks_ > 0);
}

} // namespace espalier
