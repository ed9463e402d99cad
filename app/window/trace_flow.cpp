#include "app/window/trace_flow.h"

#include "app/window/action_set.h"
#include "app/window/editing.h"
#include "core/base/error.h"
#include "core/pipeline/regrow.h"
#include "ui/document/plant_document.h"
#include "ui/tools/regrow_tool.h"
#include "ui/tools/stroke_tool.h"
#include "ui/tools/trace_tool.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <utility>

namespace espalier {
namespace {

template <class T> T* toolOf(const Editing& editing, const QString& id) {
  auto* tool = qobject_cast<T*>(&editing.toolNamed(id));
  Q_ASSERT(tool != nullptr);
  return tool;
}

} // namespace

TraceFlow::TraceFlow(const Parts& parts)
    : parts_(parts), tool_(toolOf<TraceTool>(parts.editing, "trace")),
      regrow_(toolOf<RegrowTool>(parts.editing, "regrow")) {
  connect(tool_, &TraceTool::asked, this, &TraceFlow::ask);
  connect(toolOf<StrokeTool>(parts.editing, "stroke"), &StrokeTool::asked, this, &TraceFlow::ask);
  connect(regrow_, &RegrowTool::wanted, this, &TraceFlow::regrow);
  connect(&traces_, &JobRunner::finished, this, &TraceFlow::work);
  connect(&traces_, &JobRunner::failed, this, [this](const QString& message) {
    if (const auto asked = std::exchange(next_, std::nullopt)) asked->answer({});
    emit failed(message);
  });
  connect(&traces_, &JobRunner::progressed, this, [this](double fraction) {
    if (!graph_) tool_->showReadiness(fraction);
  });
  connect(&parts_.document, &PlantDocument::scanChanged, this, &TraceFlow::forget);
  connect(&parts_.document, &PlantDocument::skeletonReplaced, tool_, &TraceTool::cancel);

  parts_.actions.beginSection(tr("Tools"));
  QAction* next = parts_.actions.add({.id = "next_way",
                                      .text = tr("Show Another Way"),
                                      .help = tr("The next way that a trace could take"),
                                      .keys = Qt::Key_Tab},
                                     [this] { tool_->showNextWay(); });
  next->setEnabled(false); // Tab leads from field to field while there is nothing to choose
  connect(&parts_.editing, &Editing::hintChanged, next, [this, next] {
    next->setEnabled(parts_.editing.currentTool() == "trace" && tool_->hasPreview() &&
                     tool_->hasOtherWays());
  });
}

void TraceFlow::ask(const TraceQuestion& question, const TraceAnswer& answer) {
  next_ = Asked{question, answer};
  if (!traces_.isRunning()) work();
}

void TraceFlow::work() {
  if (!next_) return;
  if (!graph_) {
    makeGraph();
    return;
  }
  const Asked asked = *std::exchange(next_, std::nullopt);
  const auto trace = [graph = graph_, question = asked.question](const Progress& progress) {
    const std::vector<Eigen::Vector3d>& places = question.places;
    if (question.isDrawn)
      return std::vector{graph->through(places, question.startIsFixed, question.options, progress)};
    return graph->between({places.front(), question.startIsFixed},
                          {places.back(), question.endIsFixed}, question.options, progress);
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

void TraceFlow::makeGraph() {
  if (!parts_.document.scan()) {
    next_.reset();
    return;
  }
  tool_->showReadiness(0);
  const auto make = [cloud = parts_.document.scan()->cloud(),
                     contracted = parts_.document.contracted()](const Progress& progress) {
    return std::make_shared<const TraceGraph>(cloud, contracted, progress);
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

void TraceFlow::regrow(NodeId node) {
  if (!parts_.document.scan())
    throw Error(tr("there are no points to regrow from: open the scan first").toStdString());
  parts_.document.requireEditable();
  if (parts_.jobs.isRunning())
    throw Error(
        tr("%1 is still running: wait for it, or cancel it").arg(parts_.jobs.name()).toStdString());
  const auto grow = [skeleton = parts_.document.skeleton(), node,
                     cloud = parts_.document.scan()->cloud(),
                     options = parts_.options()](const Progress& progress) {
    return regrown(skeleton, node, cloud, {.pipeline = options}, progress);
  };
  parts_.jobs.start(tr("Regrowing"), grow, [this, node](const Skeleton& part) {
    parts_.jobs.afterwards([this, node, part] { regrow_->show(node, part); });
  });
}

} // namespace espalier
