#include "app/window/methods_flow.h"

#include "app/window/action_set.h"
#include "app/window/file_filters.h"
#include "app/window/load_reference.h"
#include "app/window/reference_flow.h"
#include "ui/document/plant_document.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>

#include <algorithm>
#include <ranges>
#include <utility>

namespace espalier {
namespace {

const QString folderKey = QStringLiteral("last_folder");

} // namespace

MethodsFlow::MethodsFlow(const Parts& parts) : parts_(parts), panel_(new MethodsPanel) {
  dock_ = new PanelDock(parts_.window,
                        {.id = "methods",
                         .title = tr("Methods"),
                         .text = tr("Table of Methods"),
                         .help = tr("Shows or hides how other structures agree with the reference"),
                         .keys = QKeySequence(Qt::SHIFT | Qt::Key_F5)},
                        panel_, this);
  connect(panel_, &MethodsPanel::addRequested, this, &MethodsFlow::choose);
  connect(panel_, &MethodsPanel::copyRequested, this, &MethodsFlow::copy);
  connect(panel_, &MethodsPanel::removeRequested, this, [this](const std::vector<int>& rows) {
    for (const int row : rows | std::views::reverse)
      if (row > 0) methods_.erase(methods_.begin() + row - 1); // the first is the plant
    list();
  });
  connect(&parts_.reference, &ReferenceFlow::changed, this, &MethodsFlow::compareAll);
  connect(&parts_.document, &PlantDocument::unitChanged, this, &MethodsFlow::list);
  connect(parts_.window.actions["show_methods"], &QAction::toggled, this,
          &MethodsFlow::startNext); // nothing is compared while nobody looks
  const auto finish = [this](const QString& error) {
    for (Method& method : methods_)
      if (method.path == running_ && method.isWaiting) {
        method.isWaiting = false;
        method.row.error = error;
      }
  };
  connect(&job_, &JobRunner::failed, this, finish);
  connect(&job_, &JobRunner::finished, this, [this] {
    running_.clear();
    list();
    startNext();
  });
  list();
}

void MethodsFlow::choose() {
  QSettings& settings = parts_.window.settings;
  const QStringList paths =
      QFileDialog::getOpenFileNames(&parts_.window.window, tr("Add structures to compare"),
                                    settings.value(folderKey).toString(), structureFilters());
  if (!paths.isEmpty()) settings.setValue(folderKey, QFileInfo(paths.front()).absolutePath());
  add(paths);
}

void MethodsFlow::add(const QStringList& paths) {
  for (const QString& path : paths)
    if (std::ranges::find(methods_, path, &Method::path) == methods_.end())
      methods_.push_back({path, {.name = QFileInfo(path).fileName()}});
  list();
  startNext();
}

void MethodsFlow::setOptions(bool isLaid, double tolerance) {
  if (std::exchange(isLaid_, isLaid) == isLaid && tolerance_ == tolerance) return;
  tolerance_ = tolerance;
  compareAll();
}

void MethodsFlow::setPlant(std::shared_ptr<const Evaluation> evaluation) {
  plant_ = std::move(evaluation);
  list();
}

void MethodsFlow::compareAll() {
  if (parts_.reference.skeleton() == nullptr && parts_.document.isEmpty())
    methods_.clear(); // another plant will have others
  for (Method& method : methods_) {
    method.row = {.name = method.row.name};
    method.isWaiting = true;
  }
  job_.cancel(); // what it found would be of before
  list();
  startNext();
}

void MethodsFlow::startNext() {
  if (job_.isRunning() || !parts_.window.actions["show_methods"]->isChecked()) return;
  const auto next = std::ranges::find(methods_, true, &Method::isWaiting);
  if (next == methods_.end() || parts_.reference.skeleton() == nullptr) return;
  running_ = next->path;
  job_.start(
      tr("Compare %1").arg(next->row.name),
      [path = running_, reference = parts_.reference.skeleton(),
       options = EvaluationOptions{.registers = isLaid_,
                                   .motion = std::nullopt,
                                   .tolerance = tolerance_}](const Progress& progress) {
        const Imported<Skeleton> read = readReference(path);
        return MethodScores::of(evaluate(read.value, *reference, options, progress));
      },
      [this](const MethodScores& scores) {
        for (Method& method : methods_)
          if (method.path == running_) {
            method.row.scores = scores;
            method.isWaiting = false;
          }
      });
  panel_->setBusy(true);
}

void MethodsFlow::list() {
  std::vector<MethodRow> rows;
  if (parts_.reference.skeleton() != nullptr) {
    rows.push_back({.name = tr("The plant"), .scores = std::nullopt, .error = {}});
    if (plant_) rows.front().scores = MethodScores::of(*plant_);
    for (const Method& method : methods_)
      rows.push_back(method.row);
  }
  panel_->show(rows, parts_.reference.name(), parts_.document.unit(),
               plant_ ? plant_->tolerance : tolerance_);
  panel_->setBusy(job_.isRunning());
}

void MethodsFlow::copy() {
  QApplication::clipboard()->setText(panel_->table());
  emit noted(tr("Copied the table of methods"));
}

} // namespace espalier
