#include "ui/document/project_recorder.h"

#include "core/base/error.h"
#include "core/project/contracted_points.h"
#include "core/project/point_bytes.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"

#include <string>
#include <utility>

namespace espalier {

ProjectRecorder::ProjectRecorder(PlantDocument& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document.undoStack(), &QUndoStack::indexChanged, this, &ProjectRecorder::follow);
  connect(&document, &PlantDocument::contractedChanged, this, [this] {
    hasNewContracted_ = project_ != nullptr;
    if (hasNewContracted_) pause_.start();
  });
  keep("unit", [&document] { return symbol(document.unit()).toStdString(); });
  connect(&document, &PlantDocument::unitChanged, this, &ProjectRecorder::noteChange);
  pause_.setSingleShot(true);
  pause_.setInterval(300); // [ms] without an edit: nobody notices a write now
  connect(&pause_, &QTimer::timeout, this, &ProjectRecorder::flush);
  piece_.setSingleShot(true);
  piece_.setInterval(30); // [ms], so that what the user does comes first
  connect(&piece_, &QTimer::timeout, this, &ProjectRecorder::goOn);
}

void ProjectRecorder::keep(const std::string& name, std::function<std::string()> text) {
  texts_[name] = std::move(text);
}

void ProjectRecorder::noteChange() {
  if (project_) pause_.start();
}

void ProjectRecorder::writeNow(const std::string& name) {
  if (!project_) return;
  save();
  if (isBehind_) return;
  try { // as in save()
    saveText(name);
  } catch (const Error& error) {
    emit failed(shownText(error));
  }
}

void ProjectRecorder::start(std::unique_ptr<Project> project) {
  project_ = std::move(project);
  saved_.clear();
  for (int i = 0; i < document_.undoStack().count(); ++i)
    saved_.push_back(document_.step(i).id);
  savedPosition_ = document_.undoStack().index();
  grown_.reset();
  isBehind_ = false;
  hasNewContracted_ = false;
  for (const auto& [name, textOf] : texts_) // what could not be read stays until it is changed
    savedTexts_[name] = project_->document(name).empty() ? std::string() : textOf();
  emit projectChanged();
}

void ProjectRecorder::writeRest() {
  hasNewContracted_ = document_.contracted() != nullptr;
  pause_.start();
}

void ProjectRecorder::growScan(const GrownReference& grown) {
  if (!project_) return;
  grown_ = {grown.scan, grown_ ? grown_->added | grown.added : grown.added};
}

void ProjectRecorder::writeLater(const std::string& name, std::function<std::string()> bytes) {
  std::erase_if(later_, [&](const Later& later) { return later.name == name; });
  later_.push_back({name, std::move(bytes)});
  piece_.start();
}

std::unique_ptr<Project> ProjectRecorder::stop() {
  if (project_) flush();
  if (!isBehind_) {
    try {
      while (project_ && (writer_ || !later_.empty()))
        writePiece();
    } catch (const Error& error) {
      emit failed(shownText(error));
    }
  }
  writer_.reset();
  later_.clear();
  piece_.stop();
  pause_.stop();
  isBehind_ = false;
  std::unique_ptr<Project> project = std::move(project_);
  if (project) emit projectChanged();
  return project;
}

void ProjectRecorder::flush() {
  if (!project_) return;
  save();
  if (isBehind_) return;
  try { // as in save()
    saveTexts();
    if (std::exchange(hasNewContracted_, false))
      writeLater(contractedName,
                 [this, step = document_.contractedStep(), points = document_.contracted()] {
                   replaceContracted(*project_, step);
                   return points ? bytesOf(*points) : std::string();
                 });
    if (project_->needsSnapshot())
      project_->takeSnapshot(document_.skeleton(), document_.leftOut(), document_.organs());
  } catch (const Error& error) {
    emit failed(shownText(error));
  }
}

void ProjectRecorder::follow() {
  if (!project_) return;
  const QUndoStack& steps = document_.undoStack();
  const bool isDrag = static_cast<std::size_t>(steps.count()) == saved_.size() &&
                      steps.index() == savedPosition_ && keptSteps() + 1 == saved_.size();
  pause_.start();
  if (!isDrag || isBehind_) save(); // a drag has dozens of steps a second: it can wait
}

std::size_t ProjectRecorder::keptSteps() const {
  const auto most =
      std::min(saved_.size(), static_cast<std::size_t>(document_.undoStack().count()));
  std::size_t kept = 0;
  while (kept < most && document_.step(static_cast<int>(kept)).id == saved_[kept])
    ++kept;
  return kept;
}

// Edits come from everywhere, and none of them may fail because the disk does: so errors end here.
void ProjectRecorder::save() {
  const int position = document_.undoStack().index();
  const std::size_t kept = keptSteps();
  std::vector<HistoryStep> added;
  for (int i = static_cast<int>(kept); i < document_.undoStack().count(); ++i)
    added.push_back(document_.step(i));
  if (added.empty() && kept == saved_.size() && position == savedPosition_) return;
  try {
    // Once no step of the project says what the envelope is, its text does, which may be from
    // before what is dropped was undone.
    if (kept < saved_.size()) saveText("envelope");
    project_->record(kept, added, static_cast<std::size_t>(position), grown_);
    grown_.reset();
    saved_.resize(kept);
    for (const HistoryStep& step : added)
      saved_.push_back(step.id);
    savedPosition_ = position;
    setBehind(false);
  } catch (const Error& error) {
    if (!isBehind_) emit failed(shownText(error));
    setBehind(true);
  }
}

void ProjectRecorder::setBehind(bool isBehind) {
  if (std::exchange(isBehind_, isBehind) != isBehind) emit behindChanged();
}

void ProjectRecorder::writePiece() {
  if (!writer_) {
    writer_.emplace(later_.front().name, later_.front().bytes());
    later_.pop_front();
    return;
  }
  if (!writer_->isDone()) writer_->writeNext(*project_);
  if (writer_->isDone()) writer_.reset();
}

void ProjectRecorder::goOn() {
  if (!project_ || (!writer_ && later_.empty())) return;
  try {
    if (!pause_.isActive() && !isBehind_) writePiece();
    piece_.start();
  } catch (const Error& error) { // reported once: they can be made again
    writer_.reset();
    later_.clear();
    emit failed(shownText(error));
  }
}

void ProjectRecorder::saveTexts() {
  for (const auto& each : texts_)
    saveText(each.first);
}

void ProjectRecorder::saveText(const std::string& name) {
  const auto found = texts_.find(name);
  if (found == texts_.end()) return;
  const std::string text = found->second();
  if (text == savedTexts_[name]) return;
  project_->setDocument(name, text);
  savedTexts_[name] = text;
}

std::unique_ptr<Project> makeProject(const PlantDocument& document,
                                     const std::filesystem::path& path) {
  auto project = std::make_unique<Project>(Project::create(path, document.history()));
  const auto& frame = document.structure().frame;
  if (frame) project->setDocument("mtg", frame->text);
  return project;
}

} // namespace espalier
