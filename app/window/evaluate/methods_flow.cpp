#include "app/window/evaluate/methods_flow.h"

#include "app/window/evaluate/load_reference.h"
#include "app/window/evaluate/reference_flow.h"
#include "app/window/files/file_filters.h"
#include "app/window/frame/action_set.h"
#include "ui/document/plant_document.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

qint64 writtenAt(const QString& path) { // [ms since 1970]
  return QFileInfo(path).lastModified().toMSecsSinceEpoch();
}

} // namespace

MethodsFlow::MethodsFlow(const Parts& parts) : parts_(parts), panel_(new MethodsPanel) {
  dock_ = new PanelDock(parts_.window,
                        {.id = "methods",
                         .title = tr("Methods"),
                         .text = tr("Table of Methods"),
                         .help = tr("Shows or hides how other structures agree with the reference"),
                         .keys = QKeySequence(Qt::SHIFT | Qt::Key_F5),
                         .menu = "panels/evaluation",
                         .manual = "compare.md#the-table-of-methods"},
                        panel_, this);
  connect(panel_, &MethodsPanel::addRequested, this, &MethodsFlow::choose);
  connect(panel_, &MethodsPanel::copyRequested, this, &MethodsFlow::copy);
  connect(panel_, &MethodsPanel::removeRequested, this, &MethodsFlow::remove);
  connect(&parts_.reference, &ReferenceFlow::changed, this, &MethodsFlow::compareAll);
  connect(&parts_.document, &PlantDocument::unitChanged, this, &MethodsFlow::list);
  connect(parts_.window.actions["show_methods"], &QAction::toggled, this,
          &MethodsFlow::startNext); // nothing is compared while nobody looks
  connect(&job_, &JobSlot::failed, this,
          [this](const QString& error) { finish([&](Method& method) { method.error = error; }); });
  connect(&job_, &JobSlot::finished, this, [this] {
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
    if (std::ranges::none_of(methods_,
                             [&](const Method& method) { return method.kept.path == path; }))
      methods_.push_back({.kept = {.path = path, .scores = std::nullopt}});
  list();
  startNext();
  emit changed();
}

void MethodsFlow::remove(const std::vector<int>& rows) {
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    if (*row > 0) methods_.erase(methods_.begin() + *row - 1); // the first is the plant
  list();
  emit changed();
}

void MethodsFlow::setOptions(const EvaluationOptions& options) {
  const bool isSame = options.registers == options_.registers && options.turns == options_.turns &&
                      options.up == options_.up && options.edit == options_.edit &&
                      options.tolerance == options_.tolerance &&
                      options.breastHeight == options_.breastHeight;
  options_ = options;
  if (!isSame) compareAll();
}

std::string MethodsFlow::text() const {
  std::vector<KeptMethod> kept;
  for (const Method& method : methods_)
    kept.push_back(method.kept);
  return textOf(kept);
}

/// What a file has been compared by stays until it is written anew.
MethodsFlow::Method MethodsFlow::methodOf(const KeptMethod& kept) {
  Method method{.kept = kept, .isWaiting = !kept.scores};
  if (!kept.scores) return method;
  const QFileInfo file(kept.path);
  if (!file.exists())
    method.error = tr("%1 is not where it was: these are the numbers that were kept")
                       .arg(QDir::toNativeSeparators(kept.path));
  else if (writtenAt(kept.path) != kept.written)
    method = {.kept = {.path = kept.path, .scores = std::nullopt}};
  return method;
}

void MethodsFlow::show(const std::string& text) {
  job_.cancel();
  methods_.clear();
  list();
  for (const KeptMethod& kept : methodsFrom(text))
    methods_.push_back(methodOf(kept));
  list();
  startNext();
}

void MethodsFlow::setPlant(std::shared_ptr<const Evaluation> evaluation) {
  plant_ = std::move(evaluation);
  list();
}

void MethodsFlow::compareAll() {
  const bool hadScores = std::ranges::any_of(
      methods_, [](const Method& method) { return method.kept.scores.has_value(); });
  for (Method& method : methods_)
    method = {.kept = {.path = method.kept.path, .scores = std::nullopt}};
  job_.cancel(); // what it found would be of before
  list();
  startNext();
  if (hadScores) emit changed();
}

void MethodsFlow::startNext() {
  if (job_.isBusy() || !parts_.window.actions["show_methods"]->isChecked()) return;
  const auto next = std::ranges::find(methods_, true, &Method::isWaiting);
  if (next == methods_.end() || parts_.reference.skeleton() == nullptr) return;
  running_ = next->kept.path;
  job_.start(
      tr("Compare %1").arg(QFileInfo(running_).fileName()),
      [path = running_, reference = parts_.reference.skeleton(),
       options = options_](const Progress& progress) {
        const qint64 written = writtenAt(path);
        const Imported<Skeleton> read = readReference(path);
        return KeptMethod{
            path, evaluate(read.value, *reference, options, progress).comparison.scores, written};
      },
      [this](const KeptMethod& found) {
        finish([&](Method& method) { method.kept = found; });
        emit changed();
      });
  panel_->setBusy(true);
}

void MethodsFlow::finish(const std::function<void(Method&)>& note) {
  for (Method& method : methods_)
    if (method.kept.path == running_ && method.isWaiting) {
      method.isWaiting = false;
      note(method);
    }
}

void MethodsFlow::list() {
  std::vector<MethodRow> rows;
  if (parts_.reference.skeleton() != nullptr) {
    rows.push_back({.name = tr("The plant"), .scores = std::nullopt, .error = {}});
    if (plant_) rows.front().scores = plant_->comparison.scores;
    for (const Method& method : methods_)
      rows.push_back({QFileInfo(method.kept.path).fileName(), method.kept.scores, method.error});
  }
  panel_->show(rows, parts_.reference.name(), parts_.document.unit(),
               plant_ ? plant_->tolerance : options_.tolerance);
  panel_->setBusy(job_.isBusy());
}

void MethodsFlow::copy() {
  QApplication::clipboard()->setText(panel_->table());
  emit noted(tr("Copied the table of methods"));
}

} // namespace espalier
