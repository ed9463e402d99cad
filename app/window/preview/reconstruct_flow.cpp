#include "app/window/preview/reconstruct_flow.h"

#include "app/window/frame/action_set.h"
#include "app/window/preview/options_text.h"
#include "core/base/error.h"
#include "core/pipeline/kept_options.h"
#include "core/skeleton/review_coverage.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/length_unit.h"
#include "ui/document/number_scale.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/document/shown_text.h"
#include "ui/jobs/job_slot.h"

#include <QAction>
#include <QElapsedTimer>
#include <QUndoStack>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace espalier {
namespace {

/// Whole numbers as the window writes them.
ShownMessage withCounts(ShownMessage message) {
  for (std::string& value : message.values) {
    bool isCount = false;
    const qulonglong count = QString::fromStdString(value).toULongLong(&isCount);
    if (isCount) value = formatCount(count).toStdString();
  }
  return message;
}

} // namespace

ReconstructFlow::ReconstructFlow(const Parts& parts)
    : document_(parts.document), jobs_(parts.jobs), actions_(parts.actions), panel_(parts.panel),
      pipeline_(std::make_shared<SharedPipeline>()) {
  QAction* action = actions_.add({.id = "reconstruct",
                                  .text = tr("Re&construct"),
                                  .help = tr("Makes the skeleton from the scan"),
                                  .icon = "reconstruct",
                                  .keys = QKeySequence(Qt::CTRL | Qt::Key_R),
                                  .menu = "skeleton/make"},
                                 [this] { start(); });
  connect(&panel_, &PipelinePanel::reconstructRequested, action, &QAction::trigger);
  connect(&panel_, &PipelinePanel::runRequested, this, [this](const Step& last) {
    actions_.guarded(
        [&] {
          start(&last);
          return true;
        },
        Refusal::inBanner);
  });
  connect(&jobs_, &JobSlot::progressed, this, [this](double, const QString& stage) {
    if (isRunning_) panel_.showRunning(stage);
  });
  connect(&jobs_, &JobSlot::failed, this, [this](const QString& message) {
    if (isRunning_) panel_.showFailed(message);
  });
  connect(&jobs_, &JobSlot::finished, this, [this] { isRunning_ = false; });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::skeletonReplaced})
    connect(&document_, signal, this, &ReconstructFlow::forgetRuns);
  connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &ReconstructFlow::refreshUsed);
}

void ReconstructFlow::setEnabled(bool isEnabled) {
  if (isEnabled && jobs_.isCanceled()) panel_.showStopped();
  isEnabled_ = isEnabled;
  setPlantShown(isEnabled);
}

void ReconstructFlow::setPlantShown(bool /*isShown*/) {
  const bool canRun = document_.scan() != nullptr && isEnabled_;
  panel_.setRunnable(canRun);
  actions_["reconstruct"]->setEnabled(canRun);
}

void ReconstructFlow::start(const Step* last, bool isConfirmed) {
  if (!isConfirmed && document_.scan() != nullptr && asksFirst(last)) return;
  emit starting();
  if (document_.scan() == nullptr)
    throw Error(tr("there is no scan to reconstruct from: open one first").toStdString());
  document_.requireWritable();
  jobs_.requireIdle();
  PipelineOptions ofKept = panel_.options();
  ofKept.leftOut = document_.leftOut();
  isRunning_ = true;
  QElapsedTimer elapsed;
  elapsed.start();
  jobs_.start(
      tr("Reconstructing"),
      [pipeline = pipeline_, cloud = document_.scan()->cloud(), options = ofKept,
       to = last != nullptr ? last->name : std::string()](const Progress& progress) {
        return pipeline->run(cloud, options, progress, to);
      },
      [this, elapsed, last, options = ofKept](const Reconstruction& result) {
        show(result, last, options, static_cast<double>(elapsed.elapsed()) / 1000);
      });
}

bool ReconstructFlow::asksFirst(const Step* last) {
  if (last != nullptr && last->makes < StepResult::skeleton) return false;
  const Corrections work = handWork(document_).corrections;
  const std::size_t reviewed =
      coverage(document_.skeleton()).nodes[static_cast<std::size_t>(ReviewState::reviewed)];
  if (document_.skeleton().isEmpty() || (work.edits == 0 && reviewed == 0)) return false;
  QStringList lost;
  if (work.edits == 1) lost.append(tr("1 edit by hand"));
  if (work.edits > 1) lost.append(tr("%1 edits by hand").arg(formatCount(work.edits)));
  if (reviewed > 0) lost.append(tr("marks of %1 reviewed nodes").arg(formatCount(reviewed)));
  const auto goOn = [this, last] {
    const auto act = [&] {
      start(last, true);
      return true;
    };
    actions_.guarded(act, Refusal::inBanner);
  };
  emit reported({.text = tr("Reconstructing replaces the skeleton, with %1. Undo brings it back")
                             .arg(lost.join(tr(" and "))),
                 .actions = {{tr("Reconstruct"), goOn}, {tr("Save Project As…"), [this] {
                                                           actions_["save_project_as"]->trigger();
                                                         }}}});
  return true;
}

PipelinePanel::StepTexts ReconstructFlow::stepTexts() const {
  return [costs = pipeline_->costs(), notes = notes_](const Step& step) -> PipelinePanel::StepText {
    const auto cost = costs.find(step.name);
    if (cost == costs.end()) return {};
    const auto& [seconds, bytes] = cost->second;
    const QString time = numberText(seconds, seconds < 0.995 ? 2 : 1);
    const QString memory = numberText(static_cast<double>(bytes) / 1e6, 0);
    const PipelinePanel::StepText text{
        .note = seconds < 0.005 ? QString() : tr("%1 s").arg(time),
        .details = tr("Last run: %1 s, %2 MB more memory at most").arg(time, memory)};
    const auto note = notes.find(step.name);
    if (note == notes.end()) return text;
    return {.note = text.note.isEmpty() ? tr("note") : tr("note, %1").arg(text.note),
            .details = note->second + QStringLiteral("\n") + text.details};
  };
}

std::string ReconstructFlow::usedText() const {
  if (used_ == nullptr) return {};
  std::ostringstream text;
  text << static_cast<std::uint64_t>(used_->made) << ' ' << used_->last << '\n'
       << keptText(used_->options);
  return text.str();
}

void ReconstructFlow::setUsed(const std::string& text) {
  if (text.empty()) return forgetRuns();
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  Run run;
  std::uint64_t made = 0;
  std::istringstream(line) >> made >> run.last;
  run.made = StepId{made};
  run.options = keptOptions({std::istreambuf_iterator<char>(in), {}});
  forgetRuns();
  add(std::move(run));
}

void ReconstructFlow::showUsed() const {
  if (used_ != nullptr)
    panel_.showMadeWith(used_->options, stepTexts(), used_->last);
  else
    panel_.showIdle();
}

void ReconstructFlow::showDone(const std::string& last) const {
  panel_.showDone(stepTexts(), last);
}

/// What was undone before can no longer be redone.
void ReconstructFlow::add(Run run) {
  used_ = nullptr;
  std::erase_if(runs_, [this](const Run& each) { return !document_.isDone(each.made); });
  runs_.push_back(std::move(run));
  refreshUsed();
}

void ReconstructFlow::forgetRuns() {
  const bool wasUsed = std::exchange(used_, nullptr) != nullptr;
  runs_.clear();
  notes_.clear();
  if (wasUsed) emit usedChanged();
}

void ReconstructFlow::refreshUsed() {
  const auto last = std::find_if(runs_.rbegin(), runs_.rend(),
                                 [this](const Run& run) { return document_.isDone(run.made); });
  const Run* used = last == runs_.rend() ? nullptr : &*last;
  if (std::exchange(used_, used) == used) return;
  if (used_ != nullptr) notes_ = used_->notes;
  emit usedChanged();
}

QString ReconstructFlow::nameOf(const PipelineOptions& options) const {
  const QString change =
      shortChangeText({}, options, document_.scale(), symbol(document_.unit()), 100);
  return change.isEmpty() ? tr("Reconstruct") : tr("Reconstruct: %1").arg(change);
}

void ReconstructFlow::show(const Reconstruction& result, const Step* last,
                           const PipelineOptions& options, double seconds) {
  const QString time = seconds < 0.1 ? tr("less than 0.1") : numberText(seconds, 1);
  const std::string end = last != nullptr ? last->name : std::string();
  notes_.clear();
  QString said;
  for (const StepRecord& record : result.steps)
    for (const ShownMessage& message : record.notes) {
      const QString note = shownText(withCounts(message));
      QString& ofStep = notes_[record.step];
      ofStep += (ofStep.isEmpty() ? QString() : QStringLiteral("; ")) + note;
      said += QStringLiteral("; ") +
              tr("%1: %2", "step, note").arg(shownText(stepNamed(record.step).label), note);
    }
  if (last != nullptr && result.skeleton->isEmpty()) {
    document_.contract(shownText(last->label), result.contracted);
    emit done(tr("%1 done in %2 s").arg(shownText(last->label), time), end);
    return;
  }
  const StepId made = document_.reconstruct(nameOf(options), *result.skeleton, result.contracted);
  const std::size_t nodes = document_.skeleton().size();
  emit done((nodes == 1 ? tr("1 node reconstructed in %1 s").arg(time)
                        : tr("%1 nodes reconstructed in %2 s").arg(formatCount(nodes), time)) +
                said,
            end);
  if (nodes > 0) add({.options = options, .last = end, .made = made, .notes = notes_});
}

} // namespace espalier
