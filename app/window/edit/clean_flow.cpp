#include "app/window/edit/clean_flow.h"

#include "app/window/edit/points_flow.h"
#include "app/window/frame/action_set.h"
#include "core/clean/plants.h"
#include "core/clean/pole.h"
#include "core/clean/wire.h"
#include "core/pipeline/cleaning.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/document/shown_text.h"
#include "ui/panels/clean_panel.h"
#include "ui/tools/select_points_tool.h"

#include <utility>

namespace espalier {
namespace {

QString sharesText(std::size_t points, std::size_t all) {
  const double percent =
      100 * static_cast<double>(points) / static_cast<double>(std::max<std::size_t>(all, 1));
  return CleanFlow::tr("%1 of %2 points, %3 %")
      .arg(formatCount(points), formatCount(all))
      .arg(percent, 0, 'f', percent < 1 ? 2 : 1);
}

std::size_t countOf(const PlantDocument& document) {
  return static_cast<std::size_t>(document.scan()->cloud()->size());
}

QString nameOf(PointQuestion::Thing thing) {
  switch (thing) {
  case PointQuestion::Thing::pole:
    return CleanFlow::tr("Pole");
  case PointQuestion::Thing::wire:
    return CleanFlow::tr("Wire");
  case PointQuestion::Thing::plant:
    return CleanFlow::tr("Plant");
  }
  return {};
}

/// What a question is asked of.
struct Asked {
  std::shared_ptr<const PointCloud> cloud;
  PointSet leftOut;
  UpAxis up;
  PlantScale scale;
};

PointSet plantAt(const Eigen::Vector3d& place, const Asked& asked, const Progress& progress) {
  const PointCloud& cloud = *asked.cloud;
  const PlantParts plants = plantsOf(cloud, asked.leftOut, asked.up, asked.scale, {}, {}, progress);
  const Eigen::Vector3f at = (place - cloud.origin()).cast<float>();
  const auto plantOf = [&](Eigen::Index point) {
    return plants.ofPoint[static_cast<std::size_t>(point)];
  };
  const std::uint32_t plant = plantOf(nearestPoint(cloud.positions(), at));
  std::vector<Eigen::Index> points;
  for (Eigen::Index i = 0; plant != 0 && i < cloud.size(); ++i)
    if (plantOf(i) == plant) points.push_back(i);
  return PointSet::of(points);
}

/// Who clicks a pole knows that it is no stem: it may be thick.
const PoleOptions clickedPole{.mostRadius = heights(0.06), .reach = heights(0.15)};

PointSet thingAt(const PointQuestion& question, const Asked& asked, const Progress& progress) {
  const auto& [cloud, leftOut, up, scale] = asked;
  switch (question.thing) {
  case PointQuestion::Thing::pole:
    return polePointsAt(*cloud, leftOut, up, scale, question.places[0], clickedPole, progress);
  case PointQuestion::Thing::wire:
    return wirePointsBetween(*cloud, leftOut, up, scale, question.places[0], question.places[1], {},
                             progress);
  case PointQuestion::Thing::plant:
    return plantAt(question.places[0], asked, progress);
  }
  return {};
}

} // namespace

CleanFlow::CleanFlow(const Parts& parts) : parts_(parts) {
  makePanel();
  PlantDocument& document = parts_.document;
  connect(&document, &PlantDocument::scanChanged, this, &CleanFlow::forget);
  for (auto signal : {&PlantDocument::unitChanged, &PlantDocument::upChanged})
    connect(&document, signal, this, &CleanFlow::refreshScale);
  connect(&document, &PlantDocument::leftOutChanged, this, [this] {
    job_.cancel();
    refreshScale();
    refreshAside();
    refreshSelected();
  });
  connect(&document, &PlantDocument::readOnlyChanged, this, &CleanFlow::refreshSelected);
  connect(&document.pointSelection(), &PointSelection::changed, this, [this] {
    failure_.clear();
    refreshSelected();
  });
  connect(&parts_.points.tool(), &SelectPointsTool::asked, this, &CleanFlow::answer);
  connect(&job_, &JobSlot::failed, this, [this](const QString& why) { failure_ = why; });
  connect(&job_, &JobSlot::progressed, this,
          [this](double fraction) { panel_->showFinding(fraction); });
  connect(&job_, &JobSlot::finished, this, &CleanFlow::refreshSelected);
  forget();
}

void CleanFlow::makePanel() {
  ActionSet& actions = parts_.window.actions;
  actions.beginSection(tr("Points"));
  panel_ = new CleanPanel({.byHand = {{actions["points_brush"], tr("Brush")},
                                      {actions["points_box"], tr("Box")},
                                      {actions["points_lasso"], tr("Lasso")}},
                           .byClick = {{actions["points_pole"], tr("Pole")},
                                       {actions["points_wire"], tr("Wire")},
                                       {actions["points_plant"], tr("Plant")}},
                           .keepOnly = actions["keep_points"],
                           .invert = actions["invert_points"],
                           .bringBack = actions["bring_points_back"],
                           .showAside = actions["show_set_aside"]});
  addDock(new PanelDock(parts_.window,
                        {.id = "cleaning",
                         .title = tr("Cleaning"),
                         .text = tr("Clean Scan…"),
                         .help = tr("Finds ground, poles, wires, other plants and stray points, "
                                    "and sets them aside"),
                         .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C),
                         .menu = {},
                         .manual = "clean.md#the-panel-of-cleaning"},
                        besideThePlant, panel_, this));
  connect(panel_, &CleanPanel::changed, this, &CleanFlow::find);
  connect(panel_, &CleanPanel::cancelRequested, &job_, &JobSlot::cancel);
  connect(panel_, &CleanPanel::setAsideRequested, this, [this] {
    parts_.window.actions.guarded(
        [this] {
          parts_.points.setAside(nameOfFound());
          return true;
        },
        Refusal::inBanner);
  });
}

void CleanFlow::stop() {
  job_.cancel();
}

void CleanFlow::find() {
  const auto choice = panel_->choice();
  if (!choice || parts_.document.scan() == nullptr) return;
  failure_.clear();
  panel_->showFinding(0);
  const auto work =
      [choice = *choice, cloud = parts_.document.scan()->cloud(),
       options = PipelineOptions{.root = parts_.document.root(),
                                 .up = parts_.document.up(),
                                 .leftOut = parts_.document.leftOut(),
                                 .organs = parts_.document.organs()}](const Progress& progress) {
        return leftOutBy(*choice.cleaning.method, choice.values, cloud, options, progress);
      };
  job_.start(
      tr("Finding points"), work,
      [this, name = shownText(choice->cleaning.step->label)](const Imported<PointSet>& found) {
        parts_.document.pointSelection().set(found.value);
        if (found.value.isEmpty() && !found.notes.empty())
          failure_ = tr("%1: %2").arg(name, shownText(found.notes.front()));
        keepName(name);
      });
}

void CleanFlow::answer(const PointQuestion& question, const PointAnswer& answer) {
  if (parts_.document.scan() == nullptr) return;
  failure_.clear();
  panel_->showFinding(0);
  const Asked asked{parts_.document.scan()->cloud(), parts_.document.leftOut(),
                    parts_.document.up(), parts_.document.scale()};
  job_.start(
      tr("Finding points"),
      [question, asked](const Progress& progress) { return thingAt(question, asked, progress); },
      [this, name = nameOf(question.thing), answer](const PointSet& found) {
        if (found.isEmpty())
          failure_ = tr("%1: none was found there").arg(name);
        else
          answer(found);
        keepName(name);
      });
}

/// The selection of now is what was found last.
void CleanFlow::keepName(const QString& name) {
  found_ = parts_.document.pointSelection().points();
  foundName_ = name;
}

QString CleanFlow::nameOfFound() const {
  return parts_.document.pointSelection().points() == found_ ? foundName_ : QString();
}

void CleanFlow::refreshScale() {
  if (parts_.document.scan() != nullptr)
    panel_->setScale(parts_.document.scale(), symbol(parts_.document.unit()));
}

void CleanFlow::refreshSelected() {
  if (job_.isBusy()) return; // its result is shown once it is there
  const PlantDocument& document = parts_.document;
  const PointSet& chosen = parts_.document.pointSelection().points();
  const bool isFound = !foundName_.isEmpty() && chosen == found_;
  const bool mayBeSetAside = !chosen.isEmpty() && !document.isReadOnly();
  const QString selected =
      chosen.isEmpty() ? QString()
                       : tr("Selected: %1").arg(sharesText(chosen.size(), countOf(document)));
  if (!failure_.isEmpty()) // what was selected before is so still
    panel_->showSelected(chosen.isEmpty() ? failure_ : failure_ + QStringLiteral(". ") + selected,
                         mayBeSetAside);
  else if (document.scan() == nullptr || (chosen.isEmpty() && !isFound))
    panel_->showSelected(tr("What is found is selected: mend it with the brush before you set it "
                            "aside."),
                         false);
  else if (chosen.isEmpty())
    panel_->showSelected(tr("%1: nothing found").arg(foundName_), false);
  else
    panel_->showSelected(selected, mayBeSetAside);
}

void CleanFlow::refreshAside() {
  const PlantDocument& document = parts_.document;
  const std::size_t aside = document.leftOut().size();
  panel_->showAside(document.scan() == nullptr || aside == 0
                        ? tr("No point is set aside")
                        : tr("Set aside: %1").arg(sharesText(aside, countOf(document))));
}

void CleanFlow::forget() {
  job_.cancel();
  found_ = {};
  foundName_.clear();
  failure_.clear();
  panel_->forgetChoice();
  refreshScale();
  refreshSelected();
  refreshAside();
}

} // namespace espalier
