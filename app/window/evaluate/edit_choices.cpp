#include "app/window/evaluate/edit_choices.h"

#include "app/window/frame/action_set.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

namespace espalier {
namespace {

QString idOf(const char* prefix, const std::string& name) {
  return QLatin1String(prefix) + QString::fromStdString(name);
}

} // namespace

EditChoices::EditChoices(ActionSet& actions)
    : actions_(actions), units_(new QActionGroup(this)), costs_(new QActionGroup(this)) {
  addUnits();
  addCosts();
  actions_.add({.id = "edit_merges",
                .text = tr("Merge Paths"),
                .help = tr("The edit distance lets one part stand for up to three that follow each "
                           "other, as where a spur cuts a segment in two"),
                .isCheckable = true},
               [this] {
                 EditOptions changed = options_;
                 changed.mergesPaths = actions_["edit_merges"]->isChecked();
                 choose(changed);
               });
  check();
}

void EditChoices::addUnits() {
  struct Entry {
    EditUnit unit;
    QString text, help;
  };
  for (const Entry& entry :
       {Entry{EditUnit::node, tr("Edits of Nodes"), tr("The edit distance edits single nodes")},
        Entry{EditUnit::segment, tr("Edits of Segments"),
              tr("The edit distance edits unbranched segments")},
        Entry{EditUnit::axis, tr("Edits of Axes"), tr("The edit distance edits whole axes")}})
    units_->addAction(actions_.add(
        {.id = idOf("edit_unit_", editUnitNames()[static_cast<std::size_t>(entry.unit)]),
         .text = entry.text,
         .help = entry.help,
         .isCheckable = true},
        [this, unit = entry.unit] {
          EditOptions changed = options_;
          changed.unit = unit;
          choose(changed);
        }));
}

void EditChoices::addCosts() {
  struct Entry {
    EditCost cost;
    QString text, help;
  };
  for (const Entry& entry :
       {Entry{EditCost::topology, tr("Cost of Edits: Topology"),
              tr("A part costs 1 to remove or insert, and nothing to take for another")},
        Entry{EditCost::attributes, tr("Cost of Edits: Attributes"),
              tr("As by topology, and taking one part for another costs up to 2, by length, "
                 "radius, order and direction")},
        Entry{EditCost::length, tr("Cost of Edits: Length"),
              tr("A part costs its length, or the difference to that of another")},
        Entry{EditCost::place, tr("Cost of Edits: Place"),
              tr("As by length, and the distance between the centers of two parts")},
        Entry{EditCost::shape, tr("Cost of Edits: Shape"),
              tr("A part costs its length, or the Hausdorff distance to another")}})
    costs_->addAction(actions_.add(
        {.id = idOf("edit_cost_", editCostNames()[static_cast<std::size_t>(entry.cost)]),
         .text = entry.text,
         .help = entry.help,
         .isCheckable = true},
        [this, cost = entry.cost] {
          EditOptions changed = options_;
          changed.cost = cost;
          choose(changed);
        }));
}

void EditChoices::set(const EditOptions& options) {
  options_ = options;
  check();
}

void EditChoices::fillMenu(QMenu& menu) const {
  menu.addActions(units_->actions());
  menu.addSeparator();
  menu.addActions(costs_->actions());
  menu.addSeparator();
  menu.addAction(actions_["edit_merges"]);
  menu.addAction(actions_["save_edit_mapping"]);
}

void EditChoices::choose(const EditOptions& options) {
  if (options == options_) return;
  set(options);
  emit chosen();
}

void EditChoices::check() {
  units_->actions().at(static_cast<int>(options_.unit))->setChecked(true);
  costs_->actions().at(static_cast<int>(options_.cost))->setChecked(true);
  actions_["edit_merges"]->setChecked(options_.mergesPaths);
}

} // namespace espalier
