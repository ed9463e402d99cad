#include "app/window/edit/radius_flow.h"

#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/radius/radius_edits.h"
#include "core/skeleton/select.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_slot.h"
#include "ui/panels/cross_section_panel.h"
#include "ui/tools/node_edits.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <memory>
#include <numeric>

namespace espalier {
namespace {

constexpr std::size_t atOnce = 64; // nodes: measured before one notices

/// The commands that ask the points of the scan.
QStringList ofScan() {
  return {"radius_circle", "radius_mean", "radius_maximum", "radius_hull", "pipe_measured"};
}

/// Those that ask the nodes alone.
QStringList ofNodes() {
  return {"pipe_model", "smooth_radius", "limit_radius"};
}

/// "5 × too few points, 2 × no direction"; empty if none was refused.
QString refusals(const SectionRadii& radii) {
  QStringList parts;
  for (std::size_t i = 0; i < radii.refused.size(); ++i)
    if (radii.refused[i] > 0)
      parts.append(RadiusFlow::tr("%1 × %2").arg(formatCount(radii.refused[i]),
                                                 reasonOf(static_cast<NoRadius>(i))));
  return parts.join(QStringLiteral(", "));
}

std::size_t refusedCount(const SectionRadii& radii) {
  return std::accumulate(radii.refused.begin(), radii.refused.end(), std::size_t{0});
}

} // namespace

RadiusFlow::RadiusFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("Radius"));
  addMeasures();
  addModels();
  parts_.actions.place("radius",
                       {"radius_circle", "radius_mean", "radius_maximum", "radius_hull", "",
                        "radius_up", "radius_down", "", "interpolate_radii", "smooth_radius",
                        "limit_radius", "", "pipe_model", "pipe_measured"});
  connectSection();
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged,
                      &PlantDocument::readOnlyChanged})
    connect(&parts_.document, signal, this, &RadiusFlow::refreshEnabled);
  connect(&parts_.document, &PlantDocument::skeletonEdited, this, &RadiusFlow::refreshEnabled);
  connect(&parts_.document.selection(), &Selection::changed, this, &RadiusFlow::refreshEnabled);
  refreshEnabled();
}

void RadiusFlow::addMeasures() {
  const auto add = [this](const QString& id, const QString& text, const QString& help,
                          RadiusMeasure measure) {
    parts_.actions.add({.id = id, .text = text, .help = help},
                       [this, measure] { setMeasured(measure); });
  };
  add("radius_circle", tr("Set Radius by Circle"),
      tr("A circle fitted to the cross-section, which stray points do not pull"),
      RadiusMeasure::circle);
  add("radius_mean", tr("Set Radius by Mean"),
      tr("Mean distance of the points of the cross-section to the node"), RadiusMeasure::mean);
  add("radius_maximum", tr("Set Radius by Maximum"),
      tr("Greatest distance of a point of the cross-section to the node"), RadiusMeasure::maximum);
  add("radius_hull", tr("Set Radius by Hull"),
      tr("Perimeter of the convex hull of the cross-section, over 2 pi"), RadiusMeasure::hull);
}

void RadiusFlow::addModels() {
  const auto add = [this](const QString& id, const QString& text, const QString& help, auto act) {
    parts_.actions.add({.id = id, .text = text, .help = help}, [this, act] { (this->*act)(); });
  };
  add("pipe_model", tr("Pipe Model from Here"),
      tr("All that the node carries gets thinner with what it carries"), &RadiusFlow::pipeModel);
  add("pipe_measured", tr("Pipe Model, Keep Measured"),
      tr("The same, but a radius that the points confirm stays"),
      &RadiusFlow::pipeModelAroundMeasured);
  add("smooth_radius", tr("Smooth Radii"),
      tr("Halfway to the mean of the neighbors on the axis; tapers stay"), &RadiusFlow::smooth);
  add("limit_radius", tr("Limit Radii by Parent's"), tr("No node thicker than its parent"),
      &RadiusFlow::limit);
}

void RadiusFlow::connectSection() {
  CrossSectionPanel& section = parts_.section;
  connect(&section, &CrossSectionPanel::edited, this,
          [this](const QString& name, const auto& change, Gesture gesture) {
            parts_.actions.guarded(
                [&] {
                  parts_.document.edit(name, change, gesture);
                  return true;
                },
                Refusal::inBanner);
          });
  connect(&section, &CrossSectionPanel::ringChanged, this, [this] {
    showRing();
    emit hintChanged();
  });
}

void RadiusFlow::setEnabled(bool isEnabled) {
  isEnabled_ = isEnabled;
  parts_.section.setEditable(isEnabled);
  refreshEnabled();
}

QString RadiusFlow::hint() const {
  if (!parts_.section.isPointerInside() || parts_.document.isReadOnly() || !isEnabled_) return {};
  return tr(
      "Drag the center or the rim   Arrows, Page Up and Down: the same by keys   Wheel: zoom");
}

void RadiusFlow::refreshEnabled() {
  const PlantDocument& document = parts_.document;
  const bool canEdit = isEnabled_ && !document.isReadOnly() && !document.skeleton().isEmpty();
  for (const QString& id : ofScan())
    parts_.actions[id]->setEnabled(canEdit && document.scan() != nullptr);
  for (const QString& id : ofNodes())
    parts_.actions[id]->setEnabled(canEdit);
}

/// Draws the circle of the section in the plant, unless a tool draws there what it would make.
void RadiusFlow::showRing() {
  const std::vector<Eigen::Vector3d> ring = parts_.section.ring();
  if (parts_.actions["accept"]->isEnabled() || (ring.empty() && !isRingShown_)) return;
  isRingShown_ = !ring.empty();
  Preview preview;
  if (isRingShown_) preview.lines.push_back(ring);
  parts_.view.showPreview(preview);
}

std::vector<NodeId> RadiusFlow::chosen() const {
  parts_.document.requireEditable();
  const std::vector<NodeId>& nodes = parts_.document.selection().nodes();
  if (nodes.empty()) throw Error(tr("no node is selected: select some first").toStdString());
  return nodes;
}

void RadiusFlow::measure(const std::vector<NodeId>& nodes, RadiusMeasure measure,
                         const std::function<void(const SectionRadii&)>& act) {
  PlantDocument& document = parts_.document;
  document.requireEditable();
  parts_.jobs.requireIdle();
  if (document.scan() == nullptr)
    throw Error(tr("there are no points to measure: open the scan first").toStdString());
  const Scan& scan = *document.scan();
  if (nodes.size() <= atOnce) {
    const CrossSections sections(
        document.skeleton(),
        {scan.cloud()->positions(), scan.cloud()->origin(), scan.index(), scan.spacing()});
    act(sectionRadii(sections, nodes, measure));
    return;
  }
  parts_.jobs.start(
      tr("Measuring radii"),
      [cloud = scan.cloud(), leftOut = scan.leftOut(), spacing = scan.spacing(),
       skeleton = document.skeleton(), nodes, measure](const Progress& progress) {
        const PointCloud kept = without(*cloud, leftOut);
        const SpatialIndex index(kept.positions());
        const CrossSections sections(skeleton, {kept.positions(), kept.origin(), index, spacing});
        return sectionRadii(sections, nodes, measure, progress);
      },
      [this, act](const SectionRadii& radii) {
        parts_.actions.guarded(
            [&] {
              act(radii);
              return true;
            },
            Refusal::inBanner);
      });
}

void RadiusFlow::setMeasured(RadiusMeasure by) {
  measure(chosen(), by, [this, by](const SectionRadii& radii) {
    const QString measureName = nameOf(by).toLower();
    if (radii.radii.empty())
      throw Error(tr("no radius could be measured: %1. Try another measure, or type a radius")
                      .arg(refusals(radii))
                      .toStdString());
    std::vector<NodeId> set;
    for (const auto& [id, radius] : radii.radii)
      set.push_back(id);
    const QString name = tr("Set the radius of %1 by %2").arg(nodeNames(set), measureName);
    parts_.document.edit(name, [&](SkeletonEditor& editor) {
      for (const auto& [id, radius] : radii.radii)
        editor.setRadius(id, radius, {.source = RadiusSource::measured});
    });
    const std::size_t refused = refusedCount(radii);
    if (refused > 0)
      emit reported(
          {.text = tr("Radius by %1: %2 set, %3 as before (%4)")
                       .arg(measureName, nodeNames(set), formatCount(refused), refusals(radii)),
           .isStep = true});
    else if (set.size() > atOnce)
      emit reported(
          {.text = tr("Radius by %1: %2 set").arg(measureName, nodeNames(set)), .isStep = true});
  });
}

void RadiusFlow::pipeModel() {
  const std::vector<NodeId> nodes = chosen();
  parts_.document.edit(tr("Pipe model from %1").arg(nodeNames(nodes)), [&](SkeletonEditor& editor) {
    for (const NodeId id : nodes)
      pipeModelFrom(editor, id);
  });
}

void RadiusFlow::pipeModelAroundMeasured() {
  const std::vector<NodeId> nodes = chosen();
  measure(
      downstream(parts_.document.skeleton(), nodes), RadiusMeasure::circle,
      [this, nodes](const SectionRadii& radii) {
        const std::vector<NodeId> kept = confirmedNodes(parts_.document.skeleton(), radii.radii);
        parts_.document.edit(tr("Pipe model from %1, measured radii kept").arg(nodeNames(nodes)),
                             [&](SkeletonEditor& editor) {
                               for (const NodeId id : nodes)
                                 pipeModelFrom(editor, id, kept);
                             });
        emit reported({.text = tr("Pipe model: %1 kept their radius, which the points confirm")
                                   .arg(nodeNames(kept)),
                       .isStep = true});
      });
}

void RadiusFlow::smooth() {
  const std::vector<NodeId> nodes = chosen();
  parts_.document.edit(tr("Smooth the radius of %1").arg(nodeNames(nodes)),
                       [&](SkeletonEditor& editor) { smoothRadii(editor, nodes); });
}

void RadiusFlow::limit() {
  const std::vector<NodeId> nodes = chosen();
  const int before = parts_.document.undoStack().index();
  parts_.document.edit(tr("Limit the radius of %1").arg(nodeNames(nodes)),
                       [&](SkeletonEditor& editor) { limitRadii(editor, nodes); });
  if (parts_.document.undoStack().index() == before)
    emit noted(tr("No selected node is thicker than its parent"));
}

} // namespace espalier
