// The commands of the registration, and the jobs of its points.
#include "app/window/align/registration_flow.h"
#include "app/window/files/file_filters.h"
#include "app/window/frame/action_set.h"
#include "core/align/scan_distances.h"
#include "core/base/error.h"
#include "core/cloud/point_set.h"
#include "ui/document/plant_document.h"
#include "ui/panels/registration_panel.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>

#include <utility>

namespace espalier {
namespace {

const char* const colorId = "color_scan_distance";

Legend distanceLegend(const std::vector<float>& distances, double spacing, const QString& unit) {
  constexpr double widest = 10; // spacings: what overlaps is within two
  Legend legend{.id = QStringLiteral("color_scan_distance"),
                .title = RegistrationFlow::tr("Distance to the open scan"),
                .unit = unit,
                .from = 0,
                .to = widest * spacing};
  legend.histogram = histogramOf({distances.begin(), distances.end()}, {legend.from, legend.to});
  return legend;
}

} // namespace

void RegistrationFlow::addActions() {
  ActionSet& actions = parts_.window.actions;
  actions.beginSection(tr("Registration"));
  const QString menu = "points/registration";
  actions.add({.id = "register_scan",
               .text = tr("Register Another Scan…"),
               .help = tr("Lays another scan of this plant on the open one, to join them"),
               .menu = menu},
              [this] { chooseScan(); });
  actions.place(menu, QStringList{QString()});
  actions.add(
      {.id = "fit_scan",
       .text = tr("Fit by Points"),
       .help = tr("Moves the other scan until its points lie on those of the open one. "
                  "Without targets, it may be off by up to about 5° and a tenth of the plant"),
       .menu = menu},
      [this] { fit(); });
  actions.add({.id = colorId,
               .text = tr("Color by Distance"),
               .help = tr("Colors the points of the other scan by how far the open one is: where "
                          "the two overlap, and how well"),
               .isCheckable = true,
               .menu = menu},
              [this] { colorByDistance(); });
  actions.add({.id = "remove_last_target",
               .text = tr("Take Back the Last Step"),
               .help = tr("Takes back the target that was clicked last, the last pair, or the fit "
                          "by points"),
               .keys = Qt::Key_Backspace,
               .menu = menu},
              [this] { removeLast(); });
  actions.add({.id = "reset_registration",
               .text = tr("Reset Registration"),
               .help = tr("Forgets all targets, and puts the other scan where it was at first"),
               .menu = menu},
              [this] { change([this] { registration_.reset(); }); });
  actions.add({.id = "join_scans",
               .text = tr("Join…"),
               .help = tr("Writes the points of both scans into one file, which the plant has from "
                          "then on"),
               .menu = menu},
              [this] { chooseJoined(); });
  actions.add({.id = "move_structure",
               .text = tr("Move a Structure…"),
               .help = tr("Writes a structure that was made on the other scan where that lies now"),
               .menu = menu},
              [this] { chooseStructure(); });
  actions.add({.id = "leave_registration",
               .text = tr("Leave Registration"),
               .help = tr("Puts the other scan away; the plant is as before"),
               .menu = menu},
              [this] { leave(); });
  panel_ = new RegistrationPanel(
      {*actions["register_scan"], *actions["fit_scan"], *actions[colorId], *actions["join_scans"],
       *actions["move_structure"], *actions["reset_registration"], *actions["leave_registration"]});
  dock_ = addDock(new PanelDock(parts_.window,
                                {.id = "registration",
                                 .title = tr("Registration"),
                                 .text = tr("Registration"),
                                 .help = tr("Shows or hides the targets by which another scan is "
                                            "laid on the open one"),
                                 .keys = {},
                                 .manual = "several-scans.md"},
                                besideThePlant, panel_, this));
}

void RegistrationFlow::refreshActions() {
  ActionSet& actions = parts_.window.actions;
  const bool isReady = isActive() && isEnabled_;
  const bool isPlaced = isReady && registration_.isPlaced();
  actions["register_scan"]->setEnabled(isEnabled_ && parts_.document.scan() != nullptr);
  for (const char* id : {"fit_scan", colorId, "leave_registration"})
    actions[id]->setEnabled(isReady);
  actions["remove_last_target"]->setEnabled(isReady && registration_.hasWork());
  actions["reset_registration"]->setEnabled(isReady && registration_.hasWork());
  actions["join_scans"]->setEnabled(isPlaced);
  actions["move_structure"]->setEnabled(isPlaced || (isEnabled_ && lastMotion_));
  const QString why = tr("First pick three pairs of targets, or fit by points");
  for (const char* id : {"join_scans", "move_structure"}) {
    QAction* action = actions[id];
    action->setToolTip(action->isEnabled() || !isActive() ? action->statusTip() : why);
  }
}

void RegistrationFlow::chooseScan() {
  const QString path = QFileDialog::getOpenFileName(
      &parts_.window.window, tr("Register another scan of this plant"),
      parts_.window.settings.value(folderKey).toString(), filtersOf(Content::points));
  if (path.isEmpty()) return;
  parts_.window.settings.setValue(folderKey, QFileInfo(path).absolutePath());
  begin(path);
}

void RegistrationFlow::chooseJoined() {
  QFileDialog dialog(&parts_.window.window, tr("Join the scans"), {}, tr("PLY points (*.ply)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("ply");
  const QFileInfo scan(parts_.document.scanPath());
  dialog.setDirectory(scan.absolutePath());
  dialog.selectFile(scan.completeBaseName() + "-joined.ply");
  if (dialog.exec() == QDialog::Accepted) join(dialog.selectedFiles().front());
}

void RegistrationFlow::chooseStructure() {
  const QString from = QFileDialog::getOpenFileName(
      &parts_.window.window, tr("A structure that was made on %1").arg(name()),
      parts_.window.settings.value(folderKey).toString(), filtersOf(Content::structure));
  if (from.isEmpty()) return;
  QFileDialog dialog(&parts_.window.window, tr("Write the structure that was moved"), {},
                     writableFilters(false).join(";;"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("mtg");
  const QFileInfo file(from);
  dialog.setDirectory(file.absolutePath());
  dialog.selectFile(file.completeBaseName() + "-moved.mtg");
  if (dialog.exec() == QDialog::Accepted) moveStructure(from, dialog.selectedFiles().front());
}

void RegistrationFlow::fit() {
  const Scan& open = *parts_.document.scan();
  parts_.jobs.requireIdle();
  parts_.jobs.start(
      tr("Fitting %1 by its points").arg(name()),
      [fixed = open.cloud(), leftOut = parts_.document.leftOut(), moved = other_->cloud(),
       start = registration_.motion()](const Progress& progress) {
        if (leftOut.isEmpty()) return fitClouds(*fixed, *moved, start, {}, progress);
        return fitClouds(without(*fixed, leftOut & PointSet::firstOf(fixed->size())), *moved, start,
                         {}, progress);
      },
      [this](const CloudFit& fit) {
        if (isActive()) change([&] { registration_.setFit(fit); });
      });
}

/// Values are of the places where the points were measured: others come once these are known.
void RegistrationFlow::colorByDistance() {
  distances_.cancel();
  const bool isAsked = isActive() && parts_.window.actions[colorId]->isChecked();
  if (!isAsked) {
    values_.reset();
    if (isActive()) show();
    return;
  }
  const Scan& open = *parts_.document.scan();
  distances_.start(
      tr("Distances to the open scan"),
      [fixed = open.cloud(), index = freeIndex(open), moved = other_->cloud(),
       motion = registration_.motion()](const Progress& progress) {
        return distancesToScan(*moved, motion, *fixed, index, progress);
      },
      [this, spacing = open.spacing()](std::vector<float> distances) {
        if (!isActive()) return;
        const Legend legend = distanceLegend(distances, spacing, symbol(parts_.document.unit()));
        values_ =
            PointValues{std::make_shared<const std::vector<float>>(std::move(distances)), legend};
        show();
      });
}

} // namespace espalier
