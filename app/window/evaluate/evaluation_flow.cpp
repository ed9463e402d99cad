#include "app/window/evaluate/evaluation_flow.h"

#include "app/report/comparison_colors.h"
#include "app/window/evaluate/evaluation_text.h"
#include "app/window/evaluate/reference_flow.h"
#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/ignoring_steps.h"
#include "core/base/error.h"
#include "core/evaluate/match/edit_table.h"
#include "core/evaluate/study/ranking.h"
#include "core/io/atomic_file.h"
#include "core/io/csv.h"
#include "ui/document/hand_work_text.h"
#include "ui/document/plant_document.h"
#include "ui/panels/differences_panel.h"
#include "ui/panels/evaluation_panel.h"
#include "ui/panels/traits_panel.h"
#include "ui/plots/plot_view.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>

#include <ostream>
#include <utility>

namespace espalier {
namespace {

constexpr auto colorId = comparisonColorId;

struct Compared {
  Evaluation evaluation;
  std::map<std::string, ScoreInterval> intervals; // by key of the score
};

Compared compared(const Skeleton& plant, const Skeleton& reference, const EvaluationOptions& how,
                  const Progress& progress) {
  Compared made{.evaluation = evaluate(plant, reference, how, progress.part(0, 0.9)),
                .intervals = {}};
  const RankingOptions draws{.registers = false, .distance = made.evaluation.tolerance};
  made.intervals = ranking({plant}, made.evaluation.reference, draws, progress.part(0.9, 1))
                       .results.front()
                       .scores;
  return made;
}

} // namespace

EvaluationFlow::EvaluationFlow(const Parts& parts)
    : parts_(parts), editsMenu_(std::make_unique<QMenu>()) {
  parts_.window.actions.beginSection(tr("Evaluate"));
  edits_ = std::make_unique<EditChoices>(parts_.window.actions);
  parts_.window.actions.add(
      {.id = "save_edit_mapping",
       .text = tr("Save Edit Mapping…"),
       .help = tr("Writes which part stands for which, and what is removed and inserted, as CSV")},
      [this] { saveMapping(); });
  edits_->fillMenu(*editsMenu_);
  errors_ = std::make_unique<ErrorWalk>(ErrorWalk::Parts{
      parts_.document, parts_.view, parts_.jobs, parts_.window.actions, parts_.editing,
      parts_.ignoring,
      [this] { return parts_.reference.isVersion() ? parts_.reference.name() : QString(); }});
  report_ = std::make_unique<ReportFlow>(ReportFlow::Parts{parts_.document, parts_.jobs,
                                                           parts_.reference, parts_.window,
                                                           [this] { return optionsNow(); }});
  traits_ =
      std::make_unique<TraitsFlow>(TraitsFlow::Parts{parts_.document, parts_.jobs, parts_.window});
  makePanel();
  methods_ = std::make_unique<MethodsFlow>(
      MethodsFlow::Parts{parts_.document, parts_.jobs.queue(), parts_.reference, parts_.window});
  addDock(&methods_->dock());
  parts_.window.actions.place("evaluate", [this](QMenu& menu) { fillMenu(menu); });
  keepTexts();
  connectDocument();
  connectPanel();
  takeReference();
}

EvaluationFlow::~EvaluationFlow() = default;

void EvaluationFlow::makePanel() {
  const auto at = [this](const char* id) { return parts_.window.actions[id]; };
  plot_ = new PlotView;
  panel_ = new EvaluationPanel(parts_.document, {.plot = plot_,
                                                 .errors = errors_->panel(),
                                                 .alone = traits_->panel(),
                                                 .color = at(colorId),
                                                 .report = at("export_report"),
                                                 .edits = editsMenu_.get()});
  panel_->setLaid(isLaid_);
  panel_->setTurns(turns_);
  dock_ = addDock(new PanelDock(parts_.window,
                                {.id = "evaluation",
                                 .title = tr("Evaluation"),
                                 .text = tr("Evaluation"),
                                 .help = tr("Shows or hides the traits and scores of the plant"),
                                 .keys = Qt::Key_F5,
                                 .menu = "panels/evaluation",
                                 .manual = "compare.md"},
                                {.size = 260}, panel_, this)); // some rows of errors
}

void EvaluationFlow::fillMenu(QMenu& menu) const {
  const auto add = [&](const QString& id) { menu.addAction(parts_.window.actions[id]); };
  for (const char* id :
       {"load_reference", "load_reference_beside", "compare_version", "remove_reference"})
    add(id);
  menu.addSeparator();
  add("show_evaluation");
  add("show_methods");
  add(colorId);
  add("export_report");
  QMenu* edits = menu.addMenu(tr("E&dit Distance"));
  edits->addActions(editsMenu_->actions());
  menu.addSeparator();
  add("measure_light");
  add("export_plant_report");
  menu.addSeparator();
  for (const QString& id : ErrorWalk::menu())
    add(id);
}

void EvaluationFlow::setPlantShown(bool /*isShown*/) {
  report_->refresh();
  traits_->refresh();
  showTraits();
  later();
}

void EvaluationFlow::keepTexts() {
  keepInProject({.name = "evaluation",
                 .text = [this] { return text(); },
                 .show = [this](const std::string& text) { show(text); }});
  connect(this, &EvaluationFlow::changed, this, &EvaluationFlow::keptChanged);
  keepInProject({.name = "methods", // behind what they are compared with, and how
                 .text = [this] { return methods_->text(); },
                 .show = [this](const std::string& text) { methods_->show(text); }});
  connect(methods_.get(), &MethodsFlow::changed, this, &EvaluationFlow::keptChanged);
  keepInProject({.name = "wood_density",
                 .text = [this] { return traits_->densityText(); },
                 .show = [this](const std::string& text) { traits_->showDensity(text); }});
  connect(traits_.get(), &TraitsFlow::densityChanged, this, &EvaluationFlow::keptChanged);
}

void EvaluationFlow::setMade(std::optional<PipelineOptions> options) {
  report_->setMade(std::move(options));
  letGoOfPlace(); // another run is not an edit: it is laid as it would be alone
}

void EvaluationFlow::setChoices(std::vector<ChoiceRecord> records) {
  report_->setChoices(std::move(records));
}

void EvaluationFlow::setEnvelope(std::optional<ReportedEnvelope> envelope) {
  traits_->setEnvelope(std::move(envelope));
}

void EvaluationFlow::setDark(bool isDark) {
  plot_->setDark(isDark);
}

std::string EvaluationFlow::text() const {
  return textOf(EvaluationText{tolerance_, isLaid_, turns_, edits_->options(), errors_->ignored(),
                               ignoredOf_});
}

void EvaluationFlow::show(const std::string& text) {
  take({});
  take(evaluationFrom(text));
  setOptions();
  letGoOfPlace();
  later();
}

void EvaluationFlow::take(const EvaluationText& chosen) {
  tolerance_ = chosen.tolerance;
  isLaid_ = chosen.isLaid;
  turns_ = chosen.turns;
  panel_->setLaid(isLaid_);
  panel_->setTurns(turns_);
  edits_->set(chosen.edit);
  errors_->setIgnored(chosen.ignored);
  ignoredOf_ = chosen.ignoredOf;
}

void EvaluationFlow::setOptions() {
  methods_->setOptions(options());
  report_->setIgnored(errors_->ignored());
}

void EvaluationFlow::connectDocument() {
  timer_.setSingleShot(true);
  timer_.setInterval(250); // [ms]: a drag is compared when it rests
  connect(&timer_, &QTimer::timeout, this, &EvaluationFlow::start);
  PlantDocument& document = parts_.document;
  for (const char* id : {"show_evaluation", "show_methods"})
    connect(parts_.window.actions[id], &QAction::toggled, this, &EvaluationFlow::later);
  connect(parts_.window.actions["show_evaluation"], &QAction::toggled, this,
          &EvaluationFlow::showTraits);
  connect(&document, &PlantDocument::skeletonEdited, this, &EvaluationFlow::takeEdit);
  connect(&document, &PlantDocument::skeletonReplaced, this, [this] {
    report_->refresh();
    letGoOfPlace();
    forget();
    later();
  });
  connect(&document, &PlantDocument::unitChanged, this, [this] {
    if (evaluation_) show(Evaluation(*evaluation_)); // all lengths, at once
    setOptions();                                    // which say where breast height is
    setFresh(false);
    later();
  });
  connect(&document, &PlantDocument::upChanged, this, [this] { // which angles are tried
    letGoOfPlace();
    chooseAnew();
  });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged})
    connect(&document, signal, this, [this] {
      coverages_.reset();
      setFresh(false);
      later();
    });
  connect(&parts_.reference, &ReferenceFlow::changed, this, &EvaluationFlow::takeReference);
  connect(&parts_.reference, &ReferenceFlow::loaded, this, [this] {
    dock_->bringToFront();
    parts_.window.actions[colorId]->trigger();
  });
  connect(parts_.window.actions[colorId], &QAction::toggled, this, [this] {
    showColors();
    later();
  });
  connect(&job_, &JobSlot::progressed, panel_,
          [this](double fraction) { panel_->showProgress(fraction); });
  connect(&job_, &JobSlot::failed, panel_, &EvaluationPanel::showRest);
  connect(&job_, &JobSlot::finished, this, [this] {
    if (std::exchange(isOutdated_, false)) start();
  });
}

void EvaluationFlow::connectPanel() {
  connect(panel_, &EvaluationPanel::toleranceChosen, this, &EvaluationFlow::chooseTolerance);
  connect(plot_, &PlotView::toleranceChosen, this, [this](double tolerance) {
    panel_->setTolerance(tolerance);
    chooseTolerance(tolerance);
  });
  connect(panel_, &EvaluationPanel::laidChosen, this, [this](bool isLaid) {
    isLaid_ = isLaid;
    letGoOfPlace();
    chooseAnew();
  });
  connect(panel_, &EvaluationPanel::turnsChosen, this, [this](bool turns) {
    turns_ = turns;
    letGoOfPlace();
    chooseAnew();
  });
  connect(edits_.get(), &EditChoices::chosen, this, &EvaluationFlow::chooseAnew);
  connect(panel_, &EvaluationPanel::cancelRequested, this, [this] {
    isOutdated_ = false;
    job_.cancel();
    panel_->showRest(tr("Canceled"));
  });
  connect(panel_, &EvaluationPanel::compareRequested, this, &EvaluationFlow::start);
  connect(methods_.get(), &MethodsFlow::noted, this, &EvaluationFlow::noted);
  connect(report_.get(), &ReportFlow::noted, this, &EvaluationFlow::noted);
  const auto offer = [this](const QString& path) { // it took a while
    emit reported(offerToOpen(path, [this](const QString& text) { emit failed(text); }));
  };
  connect(report_.get(), &ReportFlow::written, this, offer);
  connect(traits_.get(), &TraitsFlow::noted, this, &EvaluationFlow::noted);
  connect(traits_.get(), &TraitsFlow::written, this, offer);
  connect(errors_.get(), &ErrorWalk::noted, this, &EvaluationFlow::noted);
  connect(errors_.get(), &ErrorWalk::ignoredChanged, this, [this] {
    setOptions();
    emit changed();
  });
  connect(errors_.get(), &ErrorWalk::shownAsked, dock_, &PanelDock::bringToFront);
}

void EvaluationFlow::takeReference() {
  const bool hasOne = parts_.reference.skeleton() != nullptr;
  letGoOfPlace();
  forget();
  takeIgnored();
  setOptions(); // where it lies is one of them
  panel_->setReference(hasOne ? parts_.reference.name() : QString());
  panel_->setMovable(!parts_.reference.liesInPlace());
  if (hasOne)
    panel_->setTolerance(tolerance_ > 0 ? tolerance_
                                        : usualTolerance(*parts_.reference.skeleton()));
  QAction* color = parts_.window.actions[colorId];
  if (!hasOne && color->isChecked()) parts_.window.actions["node_color_none"]->trigger();
  color->setVisible(hasOne);
  report_->refresh();
  showTraits();
  later();
}

/// What was ignored against one reference says nothing of another.
void EvaluationFlow::takeIgnored() {
  const std::string key = parts_.reference.key().toStdString();
  if (key == reference_) return;
  if (!errors_->ignored().empty()) ignoredOf_[reference_] = errors_->ignored();
  reference_ = key;
  const auto before = ignoredOf_.extract(key);
  errors_->setIgnored(before ? before.mapped() : std::vector<DifferingPart>());
  parts_.ignoring.forget();
  emit changed();
}

/// They stand in the place of scores.
void EvaluationFlow::showTraits() {
  traits_->setSeen(dock_->isShown() && parts_.reference.skeleton() == nullptr);
}

void EvaluationFlow::letGoOfPlace() {
  motion_.reset();
  coverages_.reset();
}

void EvaluationFlow::takeEdit() {
  isEdited_ = true;
  setFresh(false);
  later();
}

bool EvaluationFlow::isWanted() const {
  return parts_.reference.skeleton() != nullptr && !parts_.document.skeleton().isEmpty() &&
         (dock_->isShown() || methods_->dock().isShown() ||
          parts_.window.actions[colorId]->isChecked());
}

void EvaluationFlow::later() {
  if (isWanted() && !isFresh_) timer_.start();
}

EvaluationOptions EvaluationFlow::optionsNow() const {
  EvaluationOptions how = options();
  how.motion = motion_;
  how.isResultEdited = isEdited_;
  how.coverages = coverages_;
  if (const Scan* scan = parts_.document.scan()) how.scan = {scan->cloud(), scan->leftOut()};
  return how;
}

void EvaluationFlow::start() {
  timer_.stop();
  if (!isWanted()) return;
  if (job_.isBusy()) {
    isOutdated_ = true;
    job_.cancel();
    return;
  }
  panel_->showProgress(0);
  job_.start(
      tr("Compare"),
      [skeleton = parts_.document.skeleton(), reference = parts_.reference.skeleton(),
       how = optionsNow()](const Progress& progress) {
        return compared(skeleton, *reference, how, progress);
      },
      [this](Compared found) {
        if (isOutdated_ || timer_.isActive()) return; // the plant, or what is asked, is another now
        panel_->showRest({});
        panel_->showHandWork(handWork(parts_.document));
        motion_ = found.evaluation.motion;
        coverages_ = found.evaluation.comparison.coverages;
        isEdited_ = false;
        parts_.reference.lay(found.evaluation.motion);
        show(std::move(found.evaluation));
        panel_->showIntervals(found.intervals);
        setFresh(true);
      });
}

void EvaluationFlow::show(Evaluation evaluation) {
  evaluation_ = std::make_shared<const Evaluation>(std::move(evaluation));
  panel_->showScores(*evaluation_);
  plot_->show({.curve = evaluation_->curve,
               .chosen = evaluation_->score,
               .unit = symbol(parts_.document.unit())});
  errors_->show(evaluation_);
  methods_->setPlant(evaluation_);
  showColors();
}

void EvaluationFlow::forget() {
  evaluation_.reset();
  setFresh(false);
  panel_->forgetScores();
  plot_->show({});
  errors_->show(nullptr);
  methods_->setPlant(nullptr);
  showColors();
}

void EvaluationFlow::setFresh(bool isFresh) {
  if (isFresh_ == isFresh) return;
  isFresh_ = isFresh;
  panel_->setStale(!isFresh);
  plot_->setStale(!isFresh);
}

void EvaluationFlow::showColors() {
  const bool isOn = parts_.window.actions[colorId]->isChecked();
  const bool hasColors = isOn && evaluation_ != nullptr;
  parts_.view.setReferenceColors(
      hasColors ? std::optional(comparisonColors(evaluation_->differences.ofReference))
                : std::nullopt);
  if (isOn) // else they are those of another value
    parts_.view.setNodeColors(
        hasColors ? std::optional(comparisonColors(evaluation_->differences.ofResult))
                  : std::nullopt);
}

void EvaluationFlow::chooseTolerance(double tolerance) {
  tolerance_ = tolerance;
  chooseAnew();
}

void EvaluationFlow::chooseAnew() {
  setOptions();
  setFresh(false);
  later();
  emit changed();
}

void EvaluationFlow::saveMapping() {
  if (parts_.reference.skeleton() == nullptr)
    throw Error(tr("there is no reference to compare with: load one first").toStdString());
  if (!evaluation_ || !isFresh_)
    throw Error(tr("the plant is not compared yet, as it is: show the evaluation panel, and wait "
                   "until its numbers are no longer pale")
                    .toStdString());
  if (!evaluation_->comparison.edit)
    throw Error((edits_->options().unit == EditUnit::axis
                     ? tr("the plants have too many axes for an edit distance")
                     : tr("the plants have too many parts for an edit distance: choose Evaluate > "
                          "Edit Distance > Edits of Axes"))
                    .toStdString());
  QFileDialog dialog(&parts_.window.window, tr("Save the edit mapping"), {}, tr("Tables (*.csv)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("csv");
  proposeBeside(dialog, parts_.document, ".edits.csv");
  if (dialog.exec() != QDialog::Accepted) return;
  const QString path = dialog.selectedFiles().front();
  const auto rows = editTable(*evaluation_->comparison.edit, parts_.document.skeleton(),
                              *parts_.reference.skeleton());
  writeAtomically(toPath(path), [&](std::ostream& out) {
    for (const std::vector<std::string>& row : rows)
      out << csvLine(row);
  });
  emit noted(tr("Wrote %1").arg(QFileInfo(path).fileName()));
}

} // namespace espalier
