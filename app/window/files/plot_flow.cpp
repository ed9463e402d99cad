#include "app/window/files/plot_flow.h"

#include "app/plot/plot_files.h"
#include "app/window/files/folder_dialog.h"
#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/graph/turn_upright.h"
#include "core/pipeline/presets.h"
#include "ui/document/plant_document.h"
#include "ui/panels/plot_panel.h"

#include <QFileInfo>
#include <QMainWindow>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace espalier {
namespace {

/// From its lowest point to its highest [L].
double heightOf(const CutPlant& plant, const PointCloud& cloud, UpAxis up) {
  const Eigen::RowVector3d upward = turnUpright(up).row(2);
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const Eigen::Index point : plant.points) {
    const double height = upward * cloud.position(point);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  return highest - lowest;
}

} // namespace

PlotFlow::PlotFlow(Parts parts) : parts_(std::move(parts)) {
  makePanel();
  PlantDocument& document = parts_.document;
  connect(&document, &PlantDocument::scanChanged, this, &PlotFlow::forget);
  connect(&document, &PlantDocument::upChanged, this, &PlotFlow::forget);
  connect(&document, &PlantDocument::leftOutChanged, this, &PlotFlow::forget);
  connect(&document, &PlantDocument::unitChanged, this, &PlotFlow::showPlants);
  connect(&job_, &JobSlot::failed, this, [this](const QString& why) { words_ = why; });
  connect(&job_, &JobSlot::progressed, this, [this](double fraction) {
    panel_->showWorking(tr("%1… %2 %").arg(job_.name()).arg(static_cast<int>(100 * fraction)));
  });
  connect(&job_, &JobSlot::finished, this, &PlotFlow::showPlants);
  forget();
}

void PlotFlow::makePanel() {
  parts_.window.actions.beginSection(tr("Points"));
  panel_ = new PlotPanel;
  addDock(new PanelDock(parts_.window,
                        {.id = "plot",
                         .title = tr("Plot"),
                         .text = tr("Plot to Plants…"),
                         .help = tr("Finds the plants of a plot and writes each as a project of "
                                    "its own"),
                         .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_L),
                         .menu = {},
                         .manual = "clean.md#cut-a-plot-into-plants"},
                        besideThePlant, panel_, this));
  connect(panel_, &PlotPanel::findRequested, this, &PlotFlow::find);
  connect(panel_, &PlotPanel::cleansChanged, this, [this] {
    plants_.clear();
    words_.clear();
    showPlants();
  });
  connect(panel_, &PlotPanel::cancelRequested, &job_, &JobSlot::cancel);
  connect(panel_, &PlotPanel::pointedAt, this, &PlotFlow::select);
  connect(panel_, &PlotPanel::writeRequested, this, [this] {
    parts_.window.actions.guarded(
        [this] {
          chooseFolder();
          return true;
        },
        Refusal::inBanner);
  });
}

void PlotFlow::stop() {
  job_.cancel();
}

/// As the form has it, and if it is wished as the preset has it where the form chooses nothing.
PipelineOptions PlotFlow::howToCut() const {
  PipelineOptions options = parts_.options();
  options.root.reset(); // each plant has its own
  options.leftOut = parts_.document.leftOut();
  if (!panel_->cleans()) return options;
  const auto& cleaning = presetNamed("plot")->options.methods;
  for (const Step& step : pipelineSteps())
    if (cleaning.contains(step.name) && isOff(step, options))
      options.methods[step.name] = cleaning.at(step.name);
  return options;
}

void PlotFlow::find() {
  if (parts_.document.scan() == nullptr) return;
  panel_->showWorking(tr("Finding plants… 0 %"));
  const auto work = [cloud = parts_.document.scan()->cloud(), options = howToCut()](
                        const Progress& progress) { return cutPlot(cloud, {}, options, progress); };
  job_.start(tr("Finding plants"), work, [this](const CutPlot& cut) { show(cut); });
}

void PlotFlow::show(const CutPlot& cut) {
  plants_ = cut.plants;
  const auto size = static_cast<std::size_t>(parts_.document.scan()->cloud()->size());
  const std::size_t inPlants = std::accumulate(
      plants_.begin(), plants_.end(), std::size_t{0},
      [](std::size_t sum, const CutPlant& plant) { return sum + plant.points.size(); });
  const QString found =
      plants_.size() == 1 ? tr("One plant found.") : tr("%1 plants found.").arg(plants_.size());
  words_ = tr("%1 Of no plant: %2 of %3 points.")
               .arg(found, formatCount(size - inPlants), formatCount(size));
}

void PlotFlow::showPlants() {
  if (job_.isBusy()) return;
  const PlantDocument& document = parts_.document;
  std::vector<PlotPanel::Plant> rows;
  for (const CutPlant& plant : plants_)
    rows.push_back({formatCount(plant.points.size()),
                    formatLength(heightOf(plant, *document.scan()->cloud(), document.up()),
                                 document.unit(), 3)});
  if (rows.empty())
    panel_->showNone(words_);
  else
    panel_->showPlants(rows, words_);
}

void PlotFlow::select(std::size_t plant) {
  if (plant < plants_.size())
    parts_.document.pointSelection().set(PointSet::of(plants_[plant].points));
}

void PlotFlow::chooseFolder() {
  FolderDialog dialog(&parts_.window.window, tr("Write a project of each plant to a folder"),
                      QFileInfo(parts_.document.scanPath()).absolutePath());
  if (dialog.exec() == QDialog::Accepted) write(dialog.folder());
}

void PlotFlow::write(const QString& folder) {
  job_.requireIdle();
  std::vector<CutPlant> plants;
  for (const std::size_t place : panel_->chosen())
    plants.push_back(plants_[place]);
  if (plants.empty()) throw Error(tr("no plant has a check mark").toStdString());
  const PlotFiles files{.folder = toPath(folder),
                        .name = toPath(parts_.document.scanPath()).stem().string(),
                        .unit = symbol(parts_.document.unit()).toStdString(),
                        .up = parts_.document.up()};
  panel_->showWorking(tr("Writing projects… 0 %"));
  const auto work = [cloud = parts_.document.scan()->cloud(), plants = std::move(plants),
                     files](const Progress& progress) {
    return writePlot(*cloud, plants, files, progress);
  };
  job_.start(
      tr("Writing projects"), work,
      [this, folder, words = words_](const std::vector<PlantFile>& written) {
        words_ = words;
        emit reported(
            {.text = written.size() == 1
                         ? tr("Wrote one project to %1").arg(folder)
                         : tr("Wrote %1 projects to %2").arg(written.size()).arg(folder),
             .actions = {{tr("Show as Worklist"), [this, folder] { parts_.list(folder); }}}});
      });
}

void PlotFlow::forget() {
  job_.cancel();
  plants_.clear();
  words_.clear();
  panel_->setCleans(parts_.document.leftOut().isEmpty());
  panel_->setFindable(parts_.document.scan() != nullptr);
  showPlants();
}

} // namespace espalier
