#include "app/window/edit/organ_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/pipeline/organs_of_scan.h"
#include "ui/document/plant_document.h"
#include "ui/tools/select_points_tool.h"

#include <QAction>
#include <QMenu>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace espalier {
namespace {

const QString pointsTool = QStringLiteral("points");

struct OrganAction {
  Organ organ;
  const char* id;
  const char* text; // in menus
  const char* name; // in a sentence
  Qt::Key key;      // with Ctrl and Shift
};

constexpr std::array organActions = {
    OrganAction{Organ::wood, "organ_wood", QT_TRANSLATE_NOOP("espalier::OrganFlow", "Set to Wood"),
                QT_TRANSLATE_NOOP("espalier::OrganFlow", "wood"), Qt::Key_W},
    OrganAction{Organ::petiole, "organ_petiole",
                QT_TRANSLATE_NOOP("espalier::OrganFlow", "Set to Petiole"),
                QT_TRANSLATE_NOOP("espalier::OrganFlow", "petiole"), Qt::Key_T},
    OrganAction{Organ::blade, "organ_blade",
                QT_TRANSLATE_NOOP("espalier::OrganFlow", "Set to Blade"),
                QT_TRANSLATE_NOOP("espalier::OrganFlow", "blade"), Qt::Key_B},
    OrganAction{Organ::needle, "organ_needle",
                QT_TRANSLATE_NOOP("espalier::OrganFlow", "Set to Needle"),
                QT_TRANSLATE_NOOP("espalier::OrganFlow", "needle"), Qt::Key_E}};

QString countedPoints(std::size_t count) {
  return count == 1 ? OrganFlow::tr("1 point") : OrganFlow::tr("%1 points").arg(formatCount(count));
}

QString nameOfOrgan(Organ organ) {
  return OrganFlow::tr(std::ranges::find(organActions, organ, &OrganAction::organ)->name);
}

/// Whether a step looks for organs with these options.
bool areTaken(const PipelineOptions& options) {
  return std::ranges::any_of(
      pipelineSteps(), [&](const Step& step) { return chosenMethod(step, options).seesOrgans; });
}

} // namespace

OrganFlow::OrganFlow(const Parts& parts) : parts_(parts), job_(parts.queue, JobPriority::asked) {
  addActions();
  PlantDocument& document = parts_.document;
  for (auto signal :
       {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged, &PlantDocument::upChanged})
    connect(&document, signal, this, &OrganFlow::forget);
  connect(&document, &PlantDocument::organsChanged, this, [this] {
    refreshEnabled();
    emit countChanged();
    emit changed();
  });
  connect(&document, &PlantDocument::readOnlyChanged, this, &OrganFlow::refreshEnabled);
  connect(&document.pointSelection(), &PointSelection::changed, this, &OrganFlow::refreshEnabled);
  connect(&parts_.tool, &SelectPointsTool::ended, this, &OrganFlow::endStroke);
  connect(&parts_.editing, &Editing::hintChanged, this, [this] {
    if (painting_ && parts_.editing.currentTool() != pointsTool) paint(std::nullopt);
  });
  connect(&job_, &JobSlot::failed, this, &OrganFlow::failed);
  connect(&job_, &JobSlot::finished, this, [this] {
    if (isWanted_ && !found_ && !isCanceled_) find(); // what it was about has changed meanwhile
  });
  refreshEnabled();
}

void OrganFlow::addActions() {
  ActionSet& actions = parts_.actions;
  actions.beginSection(tr("Points"));
  QStringList ids;
  for (const OrganAction& each : organActions) {
    actions.add({.id = each.id,
                 .text = tr(each.text),
                 .help = tr("The selected points are of this organ; if none is selected, those "
                            "that are selected next"),
                 .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | each.key),
                 .isCheckable = true},
                [this, organ = each.organ] { choose(organ); });
    ids.append(each.id);
  }
  actions.add({.id = "organ_found",
               .text = tr("As It Is Found"),
               .help = tr("The organ of the selected points, or if none is selected of all, is not "
                          "set by hand any more"),
               .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F)},
              [this] {
                const PointSet& chosen = parts_.document.pointSelection().points();
                set(chosen.isEmpty() ? parts_.document.organs().all() : chosen, std::nullopt);
              });
  ids.append({"", "organ_found"});
  actions.place("points/organs", ids);
  actions.place("context/points", [this](QMenu& menu) { fillContextMenu(menu); });
}

void OrganFlow::choose(std::optional<Organ> organ) {
  const PointSet chosen = parts_.document.pointSelection().points();
  if (chosen.isEmpty()) return paint(painting_ == organ ? std::nullopt : organ);
  paint(std::nullopt);
  set(chosen, organ);
}

void OrganFlow::set(const PointSet& points, std::optional<Organ> organ) {
  PlantDocument& document = parts_.document;
  const QString count = countedPoints(points.size());
  document.setOrgans(organ ? tr("Set %1 to %2").arg(count, nameOfOrgan(*organ))
                           : tr("Let the organ of %1 be found").arg(count),
                     points, organ);
  document.pointSelection().clear();
  const QString done = organ ? tr("%1: %2").arg(count, nameOfOrgan(*organ)) : QString();
  if (organ && !areTaken(parts_.options()))
    emit noted(tr("%1. The next reconstruction takes it if its step Leaves is on").arg(done));
  else if (organ)
    emit noted(tr("%1, from the next reconstruction on").arg(done));
}

/// What is selected from now on becomes `organ`; none: it is selected as usual.
void OrganFlow::paint(std::optional<Organ> organ) {
  if (organ) {
    parts_.document.requireWritable();
    parts_.editing.useTool(pointsTool);
  }
  painting_ = organ;
  parts_.tool.setPurpose(organ ? nameOfOrgan(*organ) : QString());
  refreshEnabled();
}

void OrganFlow::endStroke() {
  const PointSet chosen = parts_.document.pointSelection().points();
  if (!painting_ || chosen.isEmpty()) return;
  parts_.actions.guarded(
      [&] {
        set(chosen, painting_);
        return true;
      },
      Refusal::atPointer);
}

void OrganFlow::setWanted(bool isWanted) {
  isWanted_ = isWanted;
  isCanceled_ = false;
  if (!isWanted)
    job_.cancel();
  else if (!found_ && !job_.isBusy())
    find();
}

void OrganFlow::giveUp() {
  if (!job_.isBusy()) return;
  isCanceled_ = true;
  job_.cancel();
  emit noted(tr("Canceled: color points by Organ again to find them"));
}

std::shared_ptr<const std::vector<float>> OrganFlow::now() const {
  const Scan* scan = parts_.document.scan();
  const OrganMarks& marks = parts_.document.organs();
  if (scan == nullptr || (!found_ && marks.isEmpty())) return nullptr;
  const Eigen::Index count = scan->cloud()->size();
  auto values = std::make_shared<std::vector<float>>(static_cast<std::size_t>(count),
                                                     std::numeric_limits<float>::quiet_NaN());
  if (found_)
    for (std::size_t i = 0; i < values->size(); ++i)
      if (const std::optional<Organ>& organ = (*found_)[i])
        (*values)[i] = static_cast<float>(*organ);
  for (const Organ organ : allOrgans)
    for (const Eigen::Index point : (marks.of(organ) & PointSet::firstOf(count)).points())
      (*values)[static_cast<std::size_t>(point)] = static_cast<float>(organ);
  return values;
}

void OrganFlow::setEnabled(bool isEnabled) {
  isEnabled_ = isEnabled;
  refreshEnabled();
  if (isEnabled && isWanted_ && !found_ && !isCanceled_ && !job_.isBusy()) find();
}

QString OrganFlow::count() const {
  const std::size_t byHand = parts_.document.organs().all().size();
  return byHand == 0 ? QString() : tr("%1 organs by hand").arg(formatCount(byHand));
}

void OrganFlow::forget() {
  const bool hadSome = std::exchange(found_, nullptr) != nullptr;
  refreshEnabled();
  emit countChanged();
  if (job_.isBusy())
    job_.cancel(); // begins again once it is over
  else if (isWanted_ && !isCanceled_)
    find();
  if (hadSome) emit changed();
}

void OrganFlow::find() {
  const Scan* scan = parts_.document.scan();
  if (scan == nullptr || !isEnabled_) return;
  PipelineOptions options = parts_.options();
  options.leftOut = parts_.document.leftOut();
  options.organs = {}; // shown over what is found
  job_.start(
      tr("Finding organs"),
      [cloud = scan->cloud(), options = std::move(options)](const Progress& progress) {
        return std::make_shared<const Found>(organsOfScan(cloud, options, progress));
      },
      [this](std::shared_ptr<const Found> found) {
        found_ = std::move(found);
        emit changed();
      });
}

void OrganFlow::fillContextMenu(QMenu& menu) const {
  if (parts_.document.pointSelection().isEmpty()) return;
  QMenu* organs = menu.addMenu(tr("Organ"));
  for (const OrganAction& each : organActions)
    organs->addAction(parts_.actions[each.id]);
  organs->addSeparator();
  organs->addAction(parts_.actions["organ_found"]);
}

void OrganFlow::refreshEnabled() {
  const PlantDocument& document = parts_.document;
  const bool canSet = isEnabled_ && document.scan() != nullptr && !document.isReadOnly();
  for (const OrganAction& each : organActions) {
    QAction* action = parts_.actions[each.id];
    action->setEnabled(canSet);
    action->setChecked(painting_ == each.organ);
  }
  parts_.actions["organ_found"]->setEnabled(canSet && !document.organs().isEmpty());
}

} // namespace espalier
