#include "app/window/evaluate/traits_flow.h"

#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/files/reported_plant.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/evaluate/traits/breast_height.h"
#include "core/io/atomic_file.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/number_scale.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_slot.h"
#include "ui/panels/traits_panel.h"

#include <QAction>
#include <QCoreApplication>
#include <QDate>
#include <QFileDialog>
#include <QMainWindow>
#include <QRegularExpression>

#include <memory>
#include <utility>

namespace espalier {
namespace {

using MadeTraits = std::pair<PlantReportAbout, PlantReportData>;

} // namespace

TraitsFlow::TraitsFlow(const Parts& parts) : parts_(parts), maker_(parts.jobs) {
  ActionSet& actions = parts_.window.actions;
  actions.add({.id = "measure_light",
               .text = tr("Measure Light"),
               .help = tr("Measures how much of its surface the plant shows to an overcast sky: "
                          "the silhouette to total area ratio (STAR)")},
              [this] { measureLight(); });
  actions.add({.id = "export_plant_report",
               .text = tr("Export Report of the Plant…"),
               .help = tr("Writes traits, wood and light of the plant by itself: with pictures as "
                          "HTML or PDF, or all numbers as CSV or JSON")},
              [this] { choose(); });
  panel_ = new TraitsPanel(parts_.document, {.load = actions["load_reference"],
                                             .beside = actions["load_reference_beside"],
                                             .light = actions["measure_light"],
                                             .report = actions["export_plant_report"]});
  connect(panel_, &TraitsPanel::densityChosen, this, [this](double density) {
    density_ = density;
    takeEdit();
    emit densityChanged();
  });
  timer_.setSingleShot(true);
  timer_.setInterval(250); // [ms]: a drag is measured when it rests
  connect(&timer_, &QTimer::timeout, this, &TraitsFlow::measure);
  PlantDocument& document = parts_.document;
  connect(&document, &PlantDocument::skeletonEdited, this, &TraitsFlow::takeEdit);
  connect(&document, &PlantDocument::skeletonReplaced, this, [this] {
    forget();
    later();
  });
  for (auto signal : {&PlantDocument::unitChanged, &PlantDocument::upChanged})
    connect(&document, signal, this, &TraitsFlow::takeEdit);
  connect(&job_, &JobSlot::failed, this, &TraitsFlow::forget);
  connect(&maker_, &ReportMaker::busyChanged, this, &TraitsFlow::refresh);
  connect(&maker_, &ReportMaker::noted, this, &TraitsFlow::noted);
  connect(&maker_, &ReportMaker::written, this, &TraitsFlow::written);
  refresh();
}

void TraitsFlow::setSeen(bool isSeen) {
  isSeen_ = isSeen;
  later();
}

void TraitsFlow::setEnvelope(std::optional<ReportedEnvelope> envelope) {
  envelope_ = std::move(envelope);
}

void TraitsFlow::refresh() {
  const bool hasPlant = !parts_.document.skeleton().isEmpty();
  parts_.window.actions["measure_light"]->setEnabled(hasPlant);
  parts_.window.actions["export_plant_report"]->setEnabled(hasPlant && !maker_.isBusy());
}

void TraitsFlow::takeEdit() {
  ++revision_;
  isFresh_ = isLightFresh_ = false;
  refresh();
  if (parts_.document.skeleton().isEmpty()) return forget();
  panel_->setStale(true);
  later();
}

void TraitsFlow::later() {
  if (isSeen_ && !isFresh_ && !parts_.document.skeleton().isEmpty()) timer_.start();
}

void TraitsFlow::forget(const QString& why) {
  ++revision_;
  timer_.stop();
  job_.cancel();
  measures_.reset();
  light_.reset();
  isFresh_ = isLightFresh_ = false;
  panel_->forget(why);
  refresh();
}

PlantMeasureOptions TraitsFlow::options() const {
  return {.up = parts_.document.up(),
          .breastHeight = breastHeightIn(symbol(parts_.document.unit()).toStdString()),
          .light = std::nullopt,
          .density = {.perCubicMeter = density_, .meters = metersIn(parts_.document.unit())}};
}

std::string TraitsFlow::densityText() const {
  return density_ > 0 ? plainDecimal(density_) : std::string();
}

void TraitsFlow::showDensity(const std::string& text) {
  density_ = 0;
  panel_->setDensity(density_);
  if (!text.empty()) {
    const std::optional<double> density = numberIn(text);
    if (!density || *density < TraitsPanel::leastDensity || *density > TraitsPanel::mostDensity)
      throw Error(tr("the density of the wood in this project cannot be read: type it again")
                      .toStdString());
    density_ = *density;
    panel_->setDensity(density_);
  }
  takeEdit();
}

void TraitsFlow::measure() {
  job_.start([plant = parts_.document.skeleton(), how = options()](
                 const Progress& progress) { return plantMeasures(plant, how, progress); },
             [this, revision = revision_](PlantMeasures measures) {
               if (revision != revision_) return; // the plant is another now
               measures_ = std::move(measures);
               isFresh_ = true;
               show();
             });
}

void TraitsFlow::show() {
  PlantMeasures shown = *measures_;
  shown.light = light_;
  panel_->show(shown, !isLightFresh_);
}

void TraitsFlow::measureLight() {
  maker_.requireIdle();
  PlantMeasureOptions how = options();
  how.light = LightOptions();
  parts_.jobs.start(
      tr("Measuring light"),
      [plant = parts_.document.skeleton(), how](const Progress& progress) {
        PlantMeasures measures = plantMeasures(plant, how, progress);
        if (!measures.light)
          throw Error(tr("the plant has no radii, and so no surface that light falls on: estimate "
                         "radii first")
                          .toStdString());
        return measures;
      },
      [this, revision = revision_](PlantMeasures measures) {
        if (revision != revision_) { // up or unit are others by now
          emit noted(tr("The plant was changed while its light was measured: measure it again"));
          return;
        }
        light_ = std::exchange(measures.light, std::nullopt);
        measures_ = std::move(measures);
        isFresh_ = isLightFresh_ = true;
        show();
        emit noted(tr("The plant shows %1 of its surface to an overcast sky (STAR)")
                       .arg(numberText(light_->star, 3)));
      });
}

void TraitsFlow::choose() {
  QFileDialog dialog(&parts_.window.window, tr("Export the report of the plant"), {},
                     tr("Web pages (*.html);;PDF (*.pdf);;Tables (*.csv);;JSON (*.json)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("html");
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    static const QRegularExpression extension(QStringLiteral("\\*\\.(\\w+)"));
    dialog.setDefaultSuffix(extension.match(filter).captured(1));
  });
  proposeBeside(dialog, parts_.document, ".traits.html");
  if (dialog.exec() == QDialog::Accepted) write(dialog.selectedFiles().front());
}

PlantReportAbout TraitsFlow::about() const {
  const PlantDocument& document = parts_.document;
  return {.plant = reportedPlant(document),
          .scan = reportedScan(document),
          .date = QDate::currentDate().toString(Qt::ISODate),
          .version = QCoreApplication::applicationVersion(),
          .unit = symbol(document.unit()),
          .handWork = handWork(document)};
}

void TraitsFlow::write(const QString& path) {
  maker_.requireIdle();
  requirePlantReportName(toPath(path));
  requireWritable(toPath(path));
  PlantMeasureOptions how = options();
  how.light = LightOptions();
  const Scan* scan = parts_.document.scan();
  PlantReportData data{.plant = parts_.document.skeleton(),
                       .up = how.up,
                       .measures = {},
                       .pixels = how.light->pixels,
                       .scan = scan != nullptr ? scan->cloud() : nullptr,
                       .envelope = envelope_};
  parts_.jobs.start(
      tr("Measuring for the report"),
      [data = std::move(data), how, description = about(),
       file = toPath(parts_.document.scanPath())](const Progress& progress) mutable {
        data.measures = plantMeasures(data.plant, how, progress.part(0, 0.95));
        identifyScan(description.scan, file, progress.part(0.95, 1));
        return std::make_shared<const MadeTraits>(std::move(description), std::move(data));
      },
      [this, path](const std::shared_ptr<const MadeTraits>& made) {
        parts_.jobs.afterwards([this, path, made] {
          const auto& [description, measured] = *made;
          auto pictures = hasPictures(toPath(path))
                              ? std::make_unique<PictureSession>(measured.plant, measured.scan,
                                                                 measured.up, description.unit)
                              : nullptr;
          maker_.start(path, std::move(pictures), [path, made](const ReportPictures& drawn) {
            writePlantReport(toPath(path), made->second, drawn, made->first);
          });
        });
      });
}

} // namespace espalier
