#include "ui/document/project_recorder.h"

#include "core/base/error.h"
#include "core/project/point_bytes.h"
#include "ui/document/plant_document.h"

#include <algorithm>
#include <string>
#include <utility>

namespace espalier {
namespace {

void writeContracted(Project& project, const PlantDocument& document) {
  const auto step = document.contractedStep();
  project.setDocument("contracted_step", step ? std::to_string(*step) : std::string());
  project.setBytes("contracted",
                   document.contracted() ? bytesOf(*document.contracted()) : std::string());
}

void writeRest(Project& project, const PlantDocument& document) {
  project.setDocument("unit", symbol(document.unit()).toStdString());
  const auto& frame = document.structure().frame;
  project.setDocument("mtg", frame ? frame->text : std::string());
  if (document.contracted()) writeContracted(project, document);
}

} // namespace

ProjectRecorder::ProjectRecorder(PlantDocument& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document.undoStack(), &QUndoStack::indexChanged, this, &ProjectRecorder::follow);
  connect(&document, &PlantDocument::contractedChanged, this, [this] {
    hasNewContracted_ = project_ != nullptr;
    if (hasNewContracted_) pause_.start();
  });
  connect(&document, &PlantDocument::unitChanged, this, [this] {
    if (project_) pause_.start();
  });
  pause_.setSingleShot(true);
  pause_.setInterval(300); // [ms] without an edit: nobody notices a write now
  connect(&pause_, &QTimer::timeout, this, &ProjectRecorder::flush);
}

void ProjectRecorder::start(std::unique_ptr<Project> project) {
  project_ = std::move(project);
  saved_ = revisionsNow();
  savedPosition_ = document_.undoStack().index();
  isBehind_ = false;
  hasNewContracted_ = false;
}

std::unique_ptr<Project> ProjectRecorder::stop() {
  if (project_) flush();
  pause_.stop();
  isBehind_ = false;
  return std::move(project_);
}

void ProjectRecorder::flush() {
  if (!project_) return;
  save(revisionsNow());
  if (isBehind_) return;
  try { // as in save()
    project_->setDocument("unit", symbol(document_.unit()).toStdString());
    if (std::exchange(hasNewContracted_, false)) writeContracted(*project_, document_);
    if (project_->needsSnapshot()) project_->takeSnapshot(document_.skeleton());
  } catch (const Error& error) {
    emit failed(QString::fromUtf8(error.what()));
  }
}

void ProjectRecorder::follow() {
  if (!project_) return;
  const std::vector<std::uint64_t> revisions = revisionsNow();
  const bool isDrag = !revisions.empty() && revisions.size() == saved_.size() &&
                      savedPosition_ == document_.undoStack().index() &&
                      revisions.back() != saved_.back() &&
                      std::equal(revisions.begin(), revisions.end() - 1, saved_.begin());
  pause_.start();
  if (!isDrag || isBehind_) save(revisions); // a drag has dozens of steps a second: it can wait
}

std::vector<std::uint64_t> ProjectRecorder::revisionsNow() const {
  std::vector<std::uint64_t> revisions;
  for (int i = 0; i < document_.undoStack().count(); ++i)
    revisions.push_back(document_.revision(i));
  return revisions;
}

// Edits come from everywhere, and none of them may fail because the disk does: so errors end here.
void ProjectRecorder::save(const std::vector<std::uint64_t>& revisions) {
  const int position = document_.undoStack().index();
  if (revisions == saved_ && position == savedPosition_) return;
  const auto kept =
      static_cast<std::size_t>(std::ranges::mismatch(revisions, saved_).in1 - revisions.begin());
  std::vector<HistoryStep> added;
  for (std::size_t i = kept; i < revisions.size(); ++i)
    added.push_back(document_.step(static_cast<int>(i)));
  try {
    project_->record(kept, added, static_cast<std::size_t>(position));
    saved_ = revisions;
    savedPosition_ = position;
    isBehind_ = false;
  } catch (const Error& error) {
    if (!std::exchange(isBehind_, true)) emit failed(QString::fromUtf8(error.what()));
  }
}

std::unique_ptr<Project> makeProject(const PlantDocument& document,
                                     const std::filesystem::path& path) {
  auto project = std::make_unique<Project>(Project::create(path, document.history()));
  writeRest(*project, document);
  return project;
}

} // namespace espalier
