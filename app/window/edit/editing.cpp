#include "app/window/edit/editing.h"

#include "app/window/edit/node_menus.h"
#include "app/window/edit/radius_wheel.h"
#include "app/window/edit/resample_flow.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "app/window/frame/menu_title.h"
#include "app/window/frame/view_sync.h"
#include "core/base/error.h"
#include "ui/tools/node_choices.h"
#include "ui/tools/registry.h"
#include "ui/tools/screen_plane.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include <algorithm>
#include <utility>

namespace espalier {

Editing::Editing(PlantDocument& document, PlantView& view, ActionSet& actions,
                 std::vector<ToolEntry> entries)
    : document_(document), canvas_(view), actions_(actions), entries_(std::move(entries)),
      toolGroup_(new QActionGroup(this)) {
  addTools();
  addNodeChoices();
  addDepth();
  addNodeEdits();
  addNavigation();
  addToMenus();
  listenTo(view);
  connect(&document_, &PlantDocument::skeletonEdited, this, [this] {
    if (!tool().isBusy()) canvas_.view().hoverAgain(); // another node may lie under the pointer now
    refreshEnabled();
  });
  connect(&document_, &PlantDocument::skeletonReplaced, this, &Editing::refreshEnabled);
  connect(&document_, &PlantDocument::readOnlyChanged, this, &Editing::refreshEnabled);
  connect(&document_.selection(), &Selection::changed, this, &Editing::hintChanged);
  refreshEnabled();
}

Editing::~Editing() {
  for (PlantView* view : canvas_.views())
    view->setInputHandler({});
}

void Editing::listenTo(PlantView& view) {
  view.setInputHandler([this, &view](const ToolInput& input) {
    return actions_.guarded([&] { return handle(view, input); }, Refusal::atPointer, true);
  });
  view.addActions(ofViews_);
  view.installEventFilter(wheel_);
}

void Editing::addView(PlantView& view) {
  canvas_.add(view);
  listenTo(view);
}

void Editing::removeView(PlantView& view) {
  if (&canvas_.view() == &view && isPending()) tool().cancel();
  view.setInputHandler({});
  canvas_.remove(view);
}

void Editing::addTools() {
  actions_.beginSection(tr("Tools"));
  accept_ = actions_.add({.id = "accept",
                          .text = tr("Accept"),
                          .help = tr("Makes what the preview shows"),
                          .keys = Qt::Key_Enter,
                          .refusal = Refusal::atPointer,
                          .menu = "edit/preview"},
                         [this] { accept(); });
  // Else it is off: Enter then belongs to the field that is typed in.
  connect(this, &Editing::hintChanged, accept_,
          [this] { accept_->setEnabled(offered() || (canEdit() && tool().hasPreview())); });
  for (const ToolEntry& entry : entries_) {
    std::unique_ptr<Tool> tool = entry.create(document_, canvas_);
    connect(tool.get(), &Tool::hintChanged, this, &Editing::hintChanged);
    connect(tool.get(), &Tool::finished, this, [this] { useTool(toolBefore_); });
    tools_.emplace(entry.id, std::move(tool));
    QAction* action = actions_.add({.id = "tool_" + entry.id,
                                    .text = entry.text,
                                    .help = entry.help,
                                    .icon = entry.icon,
                                    .keys = entry.shortcut,
                                    .isCheckable = true,
                                    .menu = "edit/tools"},
                                   [this, id = entry.id] { useTool(id); });
    toolGroup_->addAction(action);
  }
  useTool(entries_.front().id);
}

void Editing::addNodeEdits() {
  actions_.beginSection(tr("Skeleton"));
  for (const NodeEdit& edit : nodeEdits())
    edits_.append(actions_.add({.id = edit.id,
                                .text = edit.text,
                                .help = edit.help,
                                .icon = edit.icon,
                                .keys = edit.shortcut,
                                .refusal = Refusal::atPointer},
                               [this, edit] { make(edit); }));
  new ResampleFlow(
      document_, actions_, [this] { return chosenTarget().nodes; }, this);
  edits_.append(actions_["resample"]);
  // A button that has the keyboard keeps the space bar.
  keepToViews(actions_["extend_again"]);
  const auto nodes = [this] {
    return canEdit() && !tool().isBusy() ? target().nodes : std::vector<NodeId>();
  };
  wheel_ = new RadiusWheel(document_, actions_, nodes, this);
}

/// What changes nothing is no step, but gets an answer.
void Editing::make(const NodeEdit& edit) {
  document_.requireEditable();
  bool isChanged = false;
  QObject watch;
  connect(&document_, &PlantDocument::skeletonEdited, &watch, [&isChanged] { isChanged = true; });
  edit.apply(document_, chosenTarget(edit));
  if (!isChanged) emit noted(tr("%1: nothing to change here").arg(QString(edit.text).remove('&')));
}

void Editing::addNodeChoices() {
  actions_.beginSection(tr("Select"));
  for (const NodeChoice& choice : nodeChoices()) {
    if (choice.id.isEmpty()) continue; // a separator
    const auto choose = [this, choice] {
      const std::vector<NodeId> nodes =
          choice.needsNodes ? chosenTarget().nodes : document_.selection().nodes();
      document_.selection().set(choice.choose(document_.skeleton(), nodes));
      if (choice.isStep) showStep();
    };
    QAction* action = actions_.add({.id = choice.id,
                                    .text = choice.text,
                                    .help = choice.help,
                                    .keys = choice.shortcuts.value(0),
                                    .refusal = Refusal::atPointer},
                                   choose);
    action->setShortcuts(choice.shortcuts);
    if (choice.isStep) keepToViews(action); // lists and sliders have arrow keys of their own
    choices_.append(action);
  }
}

/// Its keys work where a view has the keyboard.
void Editing::keepToViews(QAction* action) {
  action->setShortcutContext(Qt::WidgetShortcut);
  ofViews_.append(action);
}

/// The node stepped to is what keys act on, and is on the screen, not at its rim.
void Editing::showStep() {
  actOnSelected();
  constexpr double rim = 0.1; // of a side of the view
  PlantView& view = canvas_.view();
  const Eigen::Vector3d place = document_.skeleton()[document_.selection().nodes().back()].position;
  const std::optional<QPointF> at = view.project(place);
  const double across = rim * view.width();
  const double down = rim * view.height();
  const QRectF inner = QRectF(view.rect()).adjusted(across, down, -across, -down);
  if (!at || !inner.contains(*at)) view.setPivot(place);
}

void Editing::addDepth() {
  actions_.beginSection(tr("Select"));
  actions_.add({.id = "select_through",
                .text = tr("Select &Through"),
                .help = tr("Clicks, boxes and lassos also take what is hidden behind wood"),
                .isCheckable = true,
                .menu = "select/through"},
               [this] {
                 const bool isThrough = actions_["select_through"]->isChecked();
                 canvas_.view().setDepth(isThrough ? Depth::through : Depth::front);
               });
}

void Editing::addNavigation() {
  actions_.beginSection(tr("View"));
  actions_.add({.id = "pivot",
                .text = tr("Turn Around This"),
                .help = tr("The place under the pointer stays in the middle"),
                .icon = "pivot",
                .keys = Qt::Key_R,
                .menu = "view/pivot"},
               [this] {
                 if (const auto place = placeUnder()) canvas_.view().setPivot(*place);
               });
  actions_.add({.id = "frame",
                .text = tr("Frame Selection"),
                .help = tr("The chosen nodes fill the view"),
                .icon = "frame",
                .keys = Qt::Key_F,
                .menu = "view/frame"},
               [this] { frameSelection(document_, canvas_.view()); });
}

void Editing::addToMenus() {
  actions_.place("select/nodes", [this](QMenu& menu) { fillNodeChoices(menu, actions_); });
  actions_.place("skeleton/edits", [this](QMenu& menu) { // but those that other menus have
    fillNodeEdits(menu, actions_, {"mark_unit_start", "radius_up", "radius_down"});
  });
  actions_.place("context/nodes", [this](QMenu& menu) { fillContextMenu(menu); });
}

void Editing::setEnabled(bool isEnabled) {
  if (!isEnabled && isPending()) tool().cancel();
  isEnabled_ = isEnabled;
  refreshEnabled();
}

QString Editing::hint() const {
  if (!isEnabled_) return tr("Drag: turn   Right drag: pan   Wheel: zoom");
  QString hint = tool().hint();
  if (const auto node = offered(); node && canvas_.view().hasFocus()) // in a list it is another's
    hint += "   " + tr("{accept} takes %1").arg(nodeName(*node));
  hint = withKeys(hint, actions_);
  return document_.isReadOnly() ? tr("Read-only   %1").arg(hint) : hint;
}

void Editing::useTool(const QString& id, bool startsWithNodes) {
  if (!tool_.isEmpty() && id != tool_) {
    const bool ends = tool_ == "reparent" || tool_ == "regrow" || tool_ == "root";
    if (!ends) toolBefore_ = tool_; // one does not come back to a tool that ends
    const QString left = std::exchange(tool_, id);
    Tool& before = *tools_.at(left);
    if (before.isBusy() || before.hasPreview() || !before.result().isEmpty()) before.cancel();
    before.leave();
    tools_.at(id)->enter(under_);
    canvas_.showBand({}); // of the tool before
  }
  tool_ = id;
  if (toolBefore_.isEmpty()) toolBefore_ = id;
  const std::vector<NodeId> nodes = target().nodes;
  if (startsWithNodes && !nodes.empty()) {
    tool().startWith(nodes);
    if (isPending()) canvas_.view().setFocus(); // Enter and arrows in a list mean something else
  }
  actions_["tool_" + tool_]->setChecked(true);
  refreshEnabled();
}

std::optional<NodeId> Editing::offered() const {
  const std::vector<NodeId>& nodes = document_.selection().nodes();
  const bool isTaken = isEnabled_ && nodes.size() == 1 && tool().takesNodes();
  return isTaken ? std::optional(nodes.front()) : std::nullopt;
}

void Editing::accept() {
  if (const auto node = offered())
    tool().takeNode(*node);
  else if (tool().hasPreview()) {
    document_.requireEditable();
    tool().accept();
  } else
    return;
  emit hintChanged();
}

void Editing::undo() {
  if (isPending())
    tool().cancel();
  else {
    document_.requireWritable();
    document_.undoStack().undo();
  }
}

void Editing::redo() {
  if (isPending()) return;
  document_.requireWritable();
  document_.undoStack().redo();
}

void Editing::escape() {
  if (isPending() || !result().isEmpty()) {
    tool().cancel();
    emit hintChanged();
  } else if (tool_ != entries_.front().id)
    useTool(entries_.front().id);
  else {
    document_.selection().clear();
    document_.pointSelection().clear();
  }
}

void Editing::fillContextMenu(QMenu& menu) const {
  const std::vector<NodeId> nodes = target().nodes;
  const auto begun = [](QString text) {
    text[0] = text[0].toUpper();
    return text;
  };
  const auto fill = [this](QMenu& to) {
    fillNodeEdits(to, actions_);
    to.insertAction(actions_["stick"], actions_["tool_reparent"]);
    to.insertSeparator(actions_["remove"]);
  };
  if (nodeUnder() && !nodes.empty()) {
    addTitle(menu, begun(nodeNames(nodes)));
    fill(menu);
  } else {
    addTitle(menu, titleUnder());
    if (under_.edge) menu.addAction(actions_["split_edge"]);
    if (!nodes.empty()) fill(*menu.addMenu(begun(nodeNames(nodes))));
  }
  menu.addSeparator();
  if (placeUnder()) menu.addAction(actions_["pivot"]);
  for (const char* id : {"frame", "frame_all"})
    menu.addAction(actions_[id]);
  if (!under_.node && !under_.edge)
    for (const char* id : {"hide_explained", "select_all"})
      menu.addAction(actions_[id]);
}

/// The name of what is under the pointer, other than a node.
QString Editing::titleUnder() const {
  if (under_.edge) return tr("Edge of %1").arg(nodeName(under_.edge->child));
  if (!under_.point) return tr("Empty space");
  QStringList at;
  for (const double coordinate : *under_.point)
    at.append(formatLength(coordinate, LengthUnit::unknown));
  const QString unit = symbol(document_.unit());
  return tr("Point at %1").arg(at.join(QStringLiteral(", "))) + (unit.isEmpty() ? "" : " " + unit);
}

std::optional<QPointF> Editing::pointer() const {
  return canvas_.view().underMouse() ? std::optional(pointer_) : std::nullopt;
}

std::optional<NodeId> Editing::nodeUnder() const {
  std::optional<NodeId> node = under_.node;
  if (!node && under_.edge) node = under_.edge->child;
  if (node && !document_.skeleton().contains(*node)) return std::nullopt; // removed since
  return node;
}

void Editing::actOnSelected() {
  restsAt_ = pointer_;
  under_ = {};
}

void Editing::actOnPointed() {
  restsAt_.reset();
  canvas_.view().hoverAgain();
}

bool Editing::handle(PlantView& view, const ToolInput& input) {
  // One view keeps the gesture it began; what comes from the others meanwhile is not for a tool.
  if (&canvas_.view() != &view && tool().isBusy()) return true;
  canvas_.activate(view);
  const bool isHover = input.phase == ToolInput::Phase::hover;
  if (!isHover || restsAt_ != input.screen) restsAt_.reset(); // else the camera moved, not it
  under_ = restsAt_ ? Pick{} : input.pick;
  pointer_ = input.screen;
  viewDirection_ = input.viewDirection;
  emit pointed();
  if (borrower_) return borrower_(input);
  if (isHover) view.setHovered(isEnabled_ ? under_ : Pick{});
  if (!isEnabled_) return false;
  if (isMenuClick(input)) {
    emit contextMenuRequested(view.mapToGlobal(input.screen.toPoint()));
    return true;
  }
  return canUse(currentEntry()) && tool().handle(input);
}

const ToolEntry& Editing::currentEntry() const {
  return *std::ranges::find(entries_, tool_, &ToolEntry::id);
}

bool Editing::isMenuClick(const ToolInput& input) {
  if (input.phase == ToolInput::Phase::press) {
    menuPress_.reset();
    if (input.button == Qt::RightButton) menuPress_ = input.screen;
  }
  if (menuPress_ && isDragged(*menuPress_, input.screen)) menuPress_.reset(); // a pan
  return input.phase == ToolInput::Phase::release && std::exchange(menuPress_, {}).has_value();
}

void Editing::refreshEnabled() {
  const bool hasNodes = !document_.skeleton().isEmpty();
  for (QAction* edit : edits_)
    edit->setEnabled(canEdit() && hasNodes);
  if (tool_ == "points") // whose points have these keys
    for (const char* id : {"remove", "remove_subtree"})
      actions_[id]->setEnabled(false);
  for (QAction* choice : choices_)
    choice->setEnabled(isEnabled_ && hasNodes);
  for (const ToolEntry& entry : entries_) {
    actions_["tool_" + entry.id]->setEnabled(canUse(entry));
    const bool isLeft = entry.id == tool_ && entry.id != entries_.front().id;
    if (isLeft && isEnabled_ && !canUse(entry)) useTool(entries_.front().id);
  }
  emit hintChanged();
}

NodeTarget Editing::chosenTarget(bool takesEdge) {
  NodeTarget meant = target();
  if (meant.nodes.empty() && !(takesEdge && meant.edge)) {
    document_.requireEditable(); // of what is drawn instead of the plant, no node can be meant
    throw Error(tr("put the pointer on a node, or select one").toStdString());
  }
  // What is edited is selected: the inspector shows it, and once it is removed the same key does
  // not fall on nodes that were selected somewhere else.
  if (!meant.nodes.empty()) document_.selection().set(meant.nodes);
  return meant;
}

NodeTarget Editing::chosenTarget(const NodeEdit& edit) {
  if (!edit.isOfSelected) return chosenTarget(edit.takesEdge);
  NodeTarget selected{.nodes = document_.selection().nodes(), .viewDirection = viewDirection_};
  if (selected.nodes.empty())
    throw Error(tr("select the node to go on from, or add a child first").toStdString());
  return selected;
}

NodeTarget Editing::target() const {
  return targetOf(document_, under_, viewDirection_);
}

std::optional<Eigen::Vector3d> Editing::placeUnder() const {
  if (under_.node && document_.skeleton().contains(*under_.node))
    return document_.skeleton()[*under_.node].position;
  if (under_.edge) return under_.edge->position;
  return under_.point;
}

} // namespace espalier
