#include "app/window/edit/trace_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/cloud/repeated_points.h"
#include "core/pipeline/regrow.h"
#include "core/skeleton/path_edits.h"
#include "ui/document/plant_document.h"
#include "ui/tools/regrow_tool.h"
#include "ui/tools/stroke_tool.h"
#include "ui/tools/trace_tool.h"
#include "ui/view/plant_view.h"

#include <Eigen/Geometry>
#include <QAction>

#include <algorithm>
#include <memory>
#include <utility>

namespace espalier {
namespace {

template <class T> T* toolOf(const Editing& editing, const QString& id) {
  auto* tool = qobject_cast<T*>(&editing.toolNamed(id));
  Q_ASSERT(tool != nullptr);
  return tool;
}

/// Of the points that are not set aside, each place once.
std::shared_ptr<const TraceGraph> graphOf(std::shared_ptr<const PointCloud> cloud,
                                          std::shared_ptr<const Eigen::Matrix3Xf> contracted,
                                          const PointSet& setAside, const Progress& progress) {
  const PointSet leftOut = setAside | repeatedPoints(*cloud, setAside);
  if (leftOut.isEmpty())
    return std::make_shared<const TraceGraph>(std::move(cloud), std::move(contracted), progress);
  const std::vector<Eigen::Index> kept = others(leftOut, cloud->size());
  if (kept.empty())
    throw Error(TraceFlow::tr("all points are set aside: bring some back").toStdString());
  if (contracted)
    contracted = std::make_shared<const Eigen::Matrix3Xf>((*contracted)(Eigen::all, kept));
  return std::make_shared<const TraceGraph>(
      std::make_shared<const PointCloud>(without(*cloud, leftOut)), contracted, progress);
}

} // namespace

TraceFlow::TraceFlow(const Parts& parts)
    : parts_(parts), tool_(toolOf<TraceTool>(parts.editing, "trace")),
      regrow_(toolOf<RegrowTool>(parts.editing, "regrow")) {
  connect(tool_, &TraceTool::asked, this, &TraceFlow::ask);
  connect(toolOf<StrokeTool>(parts.editing, "stroke"), &StrokeTool::asked, this, &TraceFlow::ask);
  connect(regrow_, &RegrowTool::wanted, this, &TraceFlow::regrow);
  connect(regrow_, &RegrowTool::reached, this, &TraceFlow::lookAt);
  connect(&traces_, &JobSlot::finished, this, &TraceFlow::work);
  connect(&traces_, &JobSlot::failed, this, [this](const QString& message) {
    if (const auto asked = std::exchange(next_, std::nullopt)) asked->answer({});
    emit failed(message);
  });
  connect(&traces_, &JobSlot::progressed, this, [this](double fraction) {
    if (!graph_) tool_->showReadiness(fraction);
  });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged})
    connect(&parts_.document, signal, this, &TraceFlow::forget);
  connect(&parts_.document, &PlantDocument::skeletonReplaced, tool_, &TraceTool::cancel);
  connect(&parts_.document, &PlantDocument::skeletonReplaced, this, [this] { wood_.reset(); });
  connect(&parts_.document, &PlantDocument::skeletonEdited, this, [this] { wood_.reset(); });

  parts_.actions.beginSection(tr("Tools"));
  QAction* next = parts_.actions.add({.id = "next_way",
                                      .text = tr("Show Another Path"),
                                      .help = tr("The next path that a trace could take"),
                                      .keys = Qt::Key_Tab,
                                      .menu = "edit/preview"},
                                     [this] { tool_->showNextPath(); });
  next->setEnabled(false); // Tab leads from field to field while there is nothing to choose
  connect(&parts_.editing, &Editing::hintChanged, next, [this, next] {
    next->setEnabled(parts_.editing.currentTool() == "trace" && tool_->hasPreview() &&
                     tool_->hasOtherPaths());
  });
  addGrowing();
}

void TraceFlow::addGrowing() {
  QAction* missing = parts_.actions.add(
      {.id = "regrow_missing",
       .text = tr("Regrow What Is Missing"),
       .help = tr("Grows branches from all points that the skeleton does not explain"),
       .icon = "regrow",
       .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N),
       .menu = "skeleton/make"},
      [this] { regrowMissing(); });
  QAction* chosen = parts_.actions.add(
      {.id = "branch_from_points",
       .text = tr("New Branch from Points"),
       .help = tr("Grows a branch from the selected points, on the nearest node"),
       .keys = QKeySequence(Qt::CTRL | Qt::Key_B),
       .refusal = Refusal::atPointer},
      [this] { growFromPoints(); });
  QAction* fewer = parts_.actions.add(
      {.id = "fewer_branches",
       .text = tr("Only Longer Branches"),
       .help = tr("Leaves the shortest fifth out of the branches that are shown to be added"),
       .keys = Qt::Key_PageUp,
       .menu = "edit/preview"},
      [this] { regrow_->showFewer(); });
  QAction* more = parts_.actions.add(
      {.id = "more_branches",
       .text = tr("Shorter Branches Too"),
       .help = tr("Shows a fifth more branches to be added, the longest of the others"),
       .keys = Qt::Key_PageDown,
       .menu = "edit/preview"},
      [this] { regrow_->showMore(); });
  QAction* take =
      parts_.actions.add({.id = "take_branch",
                          .text = tr("Take This Branch"),
                          .help = tr("Takes the branch that is proposed, and goes on to the next"),
                          .keys = QKeySequence(Qt::SHIFT | Qt::Key_Enter),
                          .refusal = Refusal::atPointer,
                          .menu = "edit/preview"},
                         [this] { regrow_->takeCurrent(); });
  QAction* drop = parts_.actions.add(
      {.id = "drop_branch",
       .text = tr("Drop This Branch"),
       .help = tr("Leaves out the branch that is proposed and what it would carry, and goes on to "
                  "the next"),
       .keys = QKeySequence(Qt::SHIFT | Qt::Key_Backspace),
       .refusal = Refusal::atPointer,
       .menu = "edit/preview"},
      [this] { regrow_->dropCurrent(); });
  connect(&parts_.editing, &Editing::hintChanged, this, [this, fewer, more, take, drop] {
    const bool isShown = parts_.editing.currentTool() == "regrow";
    fewer->setEnabled(isShown && regrow_->canShowFewer());
    more->setEnabled(isShown && regrow_->canShowMore());
    take->setEnabled(isShown && regrow_->canChoose());
    drop->setEnabled(isShown && regrow_->canChoose());
  });
  for (QAction* action : {fewer, more, take, drop})
    action->setEnabled(false);
  const auto refresh = [this, missing, chosen] {
    const PlantDocument& document = parts_.document;
    const bool mayGrow = document.scan() != nullptr && !document.skeleton().isEmpty() &&
                         !document.isReadOnly() && !parts_.jobs.isBusy();
    missing->setEnabled(mayGrow);
    chosen->setEnabled(mayGrow); // without selected points it says how to select some
  };
  connect(&parts_.document, &PlantDocument::scanChanged, this, refresh);
  connect(&parts_.editing, &Editing::hintChanged, this, refresh);
  refresh();
}

void TraceFlow::ask(const TraceQuestion& question, const TraceAnswer& answer) {
  next_ = Asked{question, answer};
  if (!traces_.isBusy()) work();
}

void TraceFlow::work() {
  if (!next_) return;
  if (!graph_) {
    makeGraph();
    return;
  }
  Asked asked = *std::exchange(next_, std::nullopt);
  asked.question.options.wood = wood();
  asked.question.options.keepsStart = asked.question.isDrawn; // a stroke says where it begins
  const auto trace = [graph = graph_, question = asked.question](const Progress& progress) {
    const std::vector<Eigen::Vector3d>& places = question.places;
    if (question.isDrawn)
      return std::vector{graph->through(places, question.startIsFixed, question.options, progress)};
    const TraceEnd start{places.front(), question.startIsFixed};
    const TraceEnd end{places.back(), question.endIsFixed};
    if (start.isFixed || !end.isFixed)
      return graph->between(start, end, question.options, progress);
    std::vector<Trace> traces = graph->between(end, start, question.options, progress);
    for (Trace& each : traces) { // it begins at the plant all the same
      std::ranges::reverse(each.places);
      std::ranges::reverse(each.radii);
    }
    return traces;
  };
  traces_.start(tr("Tracing"), trace, [this, answer = asked.answer](std::vector<Trace> traces) {
    parts_.actions.guarded(
        [&] {
          answer(traces);
          return true;
        },
        Refusal::atPointer);
  });
}

std::shared_ptr<const EdgeIndex> TraceFlow::wood() {
  if (!wood_) wood_ = std::make_shared<const EdgeIndex>(bodiesOf(parts_.document.skeleton()));
  return wood_;
}

void TraceFlow::makeGraph() {
  if (!parts_.document.scan()) {
    next_.reset();
    return;
  }
  tool_->showReadiness(0);
  const auto make = [cloud = parts_.document.scan()->cloud(),
                     contracted = parts_.document.contracted(),
                     leftOut = parts_.document.leftOut()](const Progress& progress) {
    return graphOf(cloud, contracted, leftOut, progress);
  };
  traces_.start(tr("Reading the points"), make, [this](std::shared_ptr<const TraceGraph> graph) {
    graph_ = std::move(graph); // the question that waits for it is answered once this is finished
    tool_->showReadiness(1);
  });
}

void TraceFlow::forget() {
  next_.reset();
  graph_.reset();
  traces_.cancel();
}

void TraceFlow::requireWork() const {
  if (!parts_.document.scan())
    throw Error(tr("there are no points to regrow from: open the scan first").toStdString());
  parts_.document.requireEditable();
  parts_.jobs.requireIdle();
}

PipelineOptions TraceFlow::options() const {
  PipelineOptions options = parts_.options();
  options.leftOut = parts_.document.leftOut();
  return options;
}

void TraceFlow::regrow(NodeId node) {
  requireWork();
  const auto before = std::make_shared<const Skeleton>(parts_.document.skeleton());
  const auto grow = [before, node, cloud = parts_.document.scan()->cloud(),
                     options = options()](const Progress& progress) {
    return regrown(*before, node, cloud, {.pipeline = options}, progress);
  };
  parts_.jobs.start(tr("Regrowing"), grow, [this, node, before](const Skeleton& part) {
    parts_.jobs.afterwards([this, node, before, part] {
      if (parts_.document.skeleton() != *before) {
        emit noted(tr("The plant was edited meanwhile: regrow the branch again"));
        return;
      }
      parts_.editing.useTool("regrow",
                             false); // a job drops the preview before, and with it the tool
      regrow_->show(node, part);
    });
  });
}

void TraceFlow::regrowMissing() {
  requireWork();
  const auto grow = [skeleton = parts_.document.skeleton(), cloud = parts_.document.scan()->cloud(),
                     options = options()](const Progress& progress) {
    return grownFromUnexplained(skeleton, cloud, {.pipeline = options}, progress);
  };
  parts_.jobs.start(tr("Growing what is missing"), grow, [this](std::vector<GrownBranch> grown) {
    constexpr double least = 20; // point spacings: what is shorter is noise more often than not
    const Scan* scan = parts_.document.scan();
    show(std::move(grown), tr("Regrow what is missing"),
         scan != nullptr ? least * scan->spacing() : 0);
  });
}

void TraceFlow::growFromPoints() {
  requireWork();
  const PointSet points = parts_.document.pointSelection().points() - parts_.document.leftOut();
  if (points.isEmpty())
    throw Error(tr("no point is selected: choose Select Points (C), and paint some").toStdString());
  const auto grow = [skeleton = parts_.document.skeleton(), cloud = parts_.document.scan()->cloud(),
                     points, options = options()](const Progress& progress) {
    return grownBranches(skeleton, cloud, points.points(), {.pipeline = options}, progress);
  };
  parts_.jobs.start(tr("Growing a branch"), grow, [this](std::vector<GrownBranch> grown) {
    show(std::move(grown), tr("New branch from points"), 0);
  });
}

/// Shows a branch that is proposed, with some of what is around it, from its best side.
void TraceFlow::lookAt(const std::vector<Eigen::Vector3d>& places) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& place : places)
    box.extend(place);
  const double margin =
      std::max(box.diagonal().norm() / 2, 2 * meanEdgeLength(parts_.document.skeleton()));
  PlantView& view = parts_.editing.activeView();
  const Sight sight{.nodes = {}, .places = places, .margin = margin};
  view.flyTo(view.cameraToSee(sight), focusOn(parts_.document.skeleton(), sight));
}

void TraceFlow::show(std::vector<GrownBranch> branches, const QString& text, double least) {
  parts_.jobs.afterwards([this, branches = std::move(branches), text, least] {
    parts_.editing.useTool("regrow", false);
    regrow_->show(branches, text, least);
  });
}

} // namespace espalier
