#include "app/window/review/findings_flow.h"

#include "app/window/frame/action_set.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/review/finding_remedy.h"
#include "app/window/review/findings_text.h"
#include "core/project/work_state.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/still_so.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/panels/check_form.h"
#include "ui/panels/findings_panel.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <algorithm>
#include <iterator>
#include <utility>

namespace espalier {
namespace {

bool hasNodes(const Skeleton& skeleton, const Finding& finding) {
  return std::ranges::all_of(nodesOf(finding), [&](NodeId id) { return skeleton.contains(id); });
}

/// Adds to what the checks find what was reported and is mostly still so, and takes over what is
/// reported from now on.
/// @param weaker  what they find at twice the sensitivity, asked for where something is gone
void keepStillSo(std::vector<Finding>& now, std::vector<Finding>& reported,
                 const std::function<std::vector<Finding>()>& weaker,
                 const PointDistances* distances = nullptr, double reach = 0) {
  const auto sameIn = [](const std::vector<Finding>& findings, const Finding& finding) {
    return std::ranges::find_if(findings,
                                [&](const Finding& other) { return isSame(other, finding); });
  };
  const bool isAnyGone = std::ranges::any_of(
      reported, [&](const Finding& before) { return sameIn(now, before) == now.end(); });
  if (isAnyGone)
    std::ranges::move(stillSo(reported, now, weaker(), distances, reach), std::back_inserter(now));
  std::vector<Finding> from;
  for (const Finding& finding : now) {
    const auto before = sameIn(reported, finding);
    from.push_back(before != reported.end() ? *before : finding);
  }
  reported = std::move(from);
}

CheckOptions twiceAsSensitive(CheckOptions limits) {
  limits.sensitivity = 2;
  return atSensitivity(limits);
}

} // namespace

FindingsFlow::FindingsFlow(const Parts& parts) : parts_(parts) {
  addActions();
  makePanel();
  keepInProject({.name = "ignored_findings",
                 .text = [this] { return textOf(ignored_); },
                 .show = [this](const std::string& text) { show(text); }});
  keepInProject({.name = "check_limits",
                 .text = [this] { return textOf(panel_->checks().chosen()); },
                 .show = [this](const std::string& text) { showLimits(text); }});
  keepInProject({.name = openFindingsName,
                 .text = [this] { return openNote_; },
                 .show = [this](const std::string& text) { openNote_ = text; }});
  connectParts();
  showAction();
}

bool FindingsFlow::isBusy() const {
  return timer_.isActive() || job_.isBusy() || parts_.distances.isBusy();
}

void FindingsFlow::show(const std::string& text) {
  ignored_.clear();
  list();
  ignored_ = findingsFrom(text);
  list();
}

void FindingsFlow::showLimits(const std::string& text) {
  panel_->checks().choose({});
  panel_->checks().choose(limitsFrom(text));
  checkAnew();
}

void FindingsFlow::checkAnew() {
  isScanChecked_ = false;
  reportedOfSkeleton_.clear(); // by other limits
  reportedOfScan_.clear();
  emit limitsChanged();
  later();
}

void FindingsFlow::addActions() {
  parts_.actions.beginSection(tr("Findings"));
  const auto add = [this](const char* id, const QString& text, const QString& help,
                          const QKeySequence& keys, const std::function<void()>& act) {
    return parts_.actions.add({.id = id, .text = text, .help = help, .keys = keys}, act);
  };
  add("next_finding", tr("Next Finding"), tr("Goes on to what the checks found next"), Qt::Key_F4,
      [this] { step(1); });
  add("previous_finding", tr("Previous Finding"), tr("Goes back to what the checks found before"),
      QKeySequence(Qt::SHIFT | Qt::Key_F4), [this] { step(-1); });
  add("ignore_finding", tr("Ignore Finding"),
      tr("Leaves the finding out of the list, or shows it again"),
      QKeySequence(Qt::CTRL | Qt::Key_F4), [this] { toggleIgnored(); });
  add("select_findings", tr("All Findings"), tr("Selects the nodes of all findings of the checks"),
      {}, [this] { selectAll(); });
  add("check_limits", tr("Limits of the Checks"),
      tr("Shows or hides from where on the checks report something"), {}, [this] {
        const bool isOpen = dock_->isShown() && panel_->checks().isOpen();
        dock_->bringToFront();
        panel_->checks().setOpen(!isOpen);
      });
  parts_.actions.place("review/findings",
                       {"next_finding", "previous_finding", "ignore_finding", "check_limits"});
  parts_.actions.place("select/findings", {"select_findings"});
}

void FindingsFlow::makePanel() {
  const auto at = [this](const char* id) { return parts_.actions[id]; };
  panel_ = new FindingsPanel(parts_.document, {.previous = at("previous_finding"),
                                               .next = at("next_finding"),
                                               .ignore = at("ignore_finding")});
  dock_ = addDock(new PanelDock({parts_.actions, parts_.settings, parts_.window},
                                {.id = "findings",
                                 .title = tr("Findings"),
                                 .text = tr("Findings Panel"),
                                 .help = tr("Shows or hides what the checks found"),
                                 .keys = Qt::Key_F8,
                                 .manual = "checks.md#findings"},
                                besideThePlant, panel_, this));
}

void FindingsFlow::connectParts() {
  PlantDocument& document = parts_.document;
  timer_.setSingleShot(true);
  timer_.setInterval(50); // [ms]: a drag is checked when it rests
  connect(&timer_, &QTimer::timeout, this, &FindingsFlow::refresh);
  connect(&document.selection(), &Selection::changed, this, [this] { awaitedStep_ = 0; });
  connect(&document, &PlantDocument::skeletonEdited, this, [this] {
    awaitedStep_ = 0;
    isScanChecked_ = false;
    list(); // none may be of a node that is gone
    later();
  });
  connect(&document, &PlantDocument::skeletonReplaced, this, [this] {
    ofSkeleton_.clear();
    ofScan_.clear();
    reportedOfSkeleton_.clear();
    reportedOfScan_.clear();
    isScanChecked_ = false;
    ignored_.clear();  // a project shows its own once its skeleton is there
    openNote_.clear(); // likewise
    list();
    later();
  });
  connect(&document, &PlantDocument::scanChanged, this, [this] {
    indexed_.reset();
    ofScan_.clear();
    reportedOfScan_.clear();
    isScanChecked_ = false;
    list();
    later();
  });
  connect(&document, &PlantDocument::unitChanged, this, &FindingsFlow::list);
  connect(&parts_.distances, &ScanDistances::changed, this, [this] {
    isScanChecked_ = false;
    unit_.reset();
    later();
  });
  connect(&job_, &JobSlot::finished, this, [this] {
    if (std::exchange(isJobOutdated_, false)) startJob();
    panel_->setChecking(!isAllChecked());
    noteOpen();
    answer();
  });
  connect(&job_, &JobSlot::failed, this, &FindingsFlow::noted);
  connect(dock_, &PanelDock::shown, this, [this](bool isShown) {
    parts_.distances.setWanted(ScanDistances::Use::findings, isShown);
    isAwaited_ = false;
    if (isShown) refresh(); // nothing was checked while nobody looked
  });
  connect(panel_, &FindingsPanel::chosen, this, &FindingsFlow::goTo);
  connect(panel_, &FindingsPanel::currentChanged, this, &FindingsFlow::showAction);
  connect(panel_, &FindingsPanel::currentChanged, this, &FindingsFlow::showSentence);
  connect(&panel_->checks(), &CheckForm::changed, this, [this] {
    checkAnew();
    emit keptChanged();
  });
}

void FindingsFlow::later() {
  if (dock_->isShown()) timer_.start();
}

void FindingsFlow::refresh() {
  timer_.stop();
  constexpr std::size_t most = 4000; // nodes that are checked in a few ms
  const Skeleton& skeleton = parts_.document.skeleton();
  isCheckedAtOnce_ = skeleton.size() <= most;
  if (isCheckedAtOnce_) {
    ofSkeleton_ = check(skeleton, spacing(), limits());
    keepStillSo(ofSkeleton_, reportedOfSkeleton_,
                [&] { return check(skeleton, spacing(), twiceAsSensitive(limits())); });
    list();
    noteOpen();
  }
  startJob();
}

/// What takes longer: large skeletons, and the scan.
void FindingsFlow::startJob() {
  const std::shared_ptr<const PointDistances> distances = parts_.distances.now();
  if (!distances && isCheckedAtOnce_) return; // changed() follows when they are ready
  if (job_.isBusy()) {
    isJobOutdated_ = true;
    job_.cancel();
    return;
  }
  job_.start(
      tr("Check the plant"),
      [distances, indexed = indexed_, isCheckedAtOnce = isCheckedAtOnce_, spacing = spacing(),
       options = limits(), reportedOfSkeleton = reportedOfSkeleton_,
       reportedOfScan = reportedOfScan_,
       skeleton = parts_.document.skeleton()](const Progress& progress) {
        Found found{.reportedOfSkeleton = reportedOfSkeleton, .indexed = indexed};
        if (!isCheckedAtOnce) {
          found.ofSkeleton = check(skeleton, spacing, options);
          keepStillSo(*found.ofSkeleton, found.reportedOfSkeleton,
                      [&] { return check(skeleton, spacing, twiceAsSensitive(options)); });
        }
        if (!distances) return found;
        const std::shared_ptr<const PointCloud>& cloud = distances->cloud();
        if (found.indexed && found.indexed->cloud == cloud) // else points are others
          found.reportedOfScan = reportedOfScan;
        if (!found.indexed || found.indexed->cloud != cloud)
          found.indexed =
              std::make_shared<const Indexed>(Indexed{cloud, SpatialIndex(cloud->positions())});
        found.ofScan = checkAgainstScan(skeleton, *distances, found.indexed->index, spacing,
                                        options, progress);
        const auto weaker = [&] {
          return checkAgainstScan(skeleton, *distances, found.indexed->index, spacing,
                                  twiceAsSensitive(options), progress);
        };
        keepStillSo(found.ofScan, found.reportedOfScan, weaker, distances.get(),
                    options.pointReach * exactness(*distances, spacing, options));
        return found;
      },
      [this](Found found) { take(std::move(found)); });
  panel_->setChecking(!isAllChecked());
}

void FindingsFlow::take(Found found) {
  if (found.ofSkeleton) {
    ofSkeleton_ = std::move(*found.ofSkeleton);
    reportedOfSkeleton_ = std::move(found.reportedOfSkeleton);
  }
  const std::shared_ptr<const PointDistances> now = parts_.distances.now();
  if (now && found.indexed && now->cloud() == found.indexed->cloud) {
    reportedOfScan_ = std::move(found.reportedOfScan);
    ofScan_ = std::move(found.ofScan); // else the points are others, or are measured again
    indexed_ = std::move(found.indexed);
    isScanChecked_ = !timer_.isActive(); // else it was edited meanwhile
  }
  list();
}

bool FindingsFlow::isAllChecked() const {
  if (parts_.document.scan() != nullptr) return isScanChecked_;
  return isCheckedAtOnce_ || !isBusy();
}

double FindingsFlow::spacing() const {
  const Scan* scan = parts_.document.scan();
  return scan != nullptr ? scan->spacing() : 0;
}

CheckOptions FindingsFlow::limits() const {
  CheckOptions options = panel_->checks().options();
  if (const Scan* scan = parts_.document.scan())
    options.scatter = scan->wood().scatter / scan->spacing();
  return atSensitivity(options);
}

void FindingsFlow::list() {
  findings_.clear();
  shownIgnored_.clear();
  for (const std::vector<Finding>* found : {&ofSkeleton_, &ofScan_})
    for (const Finding& finding : *found)
      if (hasNodes(parts_.document.skeleton(), finding))
        (isIgnored(finding) ? shownIgnored_ : findings_).push_back(finding);
  panel_->show(findings_, shownIgnored_);
  panel_->setChecking(!isAllChecked());
}

void FindingsFlow::noteOpen() {
  const bool isKnown = dock_->isShown() && isAllChecked() && !timer_.isActive() &&
                       !parts_.document.skeleton().isEmpty();
  if (!isKnown) return;
  const std::string now = std::to_string(findings_.size());
  if (std::exchange(openNote_, now) != now) emit keptChanged();
}

bool FindingsFlow::isIgnored(const Finding& finding) const {
  return std::ranges::any_of(ignored_,
                             [&](const Finding& other) { return isSame(other, finding); });
}

void FindingsFlow::ignore(const Finding& finding) {
  if (isIgnored(finding)) return;
  ignored_.push_back(finding);
  list();
  noteOpen();
  emit keptChanged();
}

void FindingsFlow::step(int by) {
  dock_->bringToFront();
  if (timer_.isActive()) refresh();
  if (findings_.empty()) {
    noteNothing();
    awaitedStep_ = isAwaited_ ? by : 0;
    return;
  }
  const std::optional<Finding> current = panel_->current();
  const auto at = std::ranges::find_if(
      findings_, [&](const Finding& finding) { return current && isSame(finding, *current); });
  const auto count = static_cast<std::ptrdiff_t>(findings_.size());
  std::ptrdiff_t next = by > 0 ? 0 : count - 1;
  if (at != findings_.end()) next = (at - findings_.begin() + by + count) % count;
  const Finding finding = findings_[static_cast<std::size_t>(next)];
  panel_->setCurrent(finding);
  goTo(finding);
}

void FindingsFlow::noteNothing() {
  const bool hasSkeleton = !parts_.document.skeleton().isEmpty();
  isAwaited_ = hasSkeleton && !isAllChecked();
  emit noted(!hasSkeleton ? tr("There is no skeleton to check yet")
             : isAwaited_ ? tr("Checking against the scan…")
                          : tr("Nothing to look at: all checks pass"));
}

/// To who has asked for findings before there were any, and done nothing else since.
void FindingsFlow::answer() {
  const int by = findings_.empty() ? 0 : std::exchange(awaitedStep_, 0);
  if (!isAwaited_ || (by == 0 && !isAllChecked())) return;
  isAwaited_ = false;
  if (findings_.empty()) return noteNothing();
  if (by != 0) step(by);
  if (!isAllChecked()) return;
  const QString ended =
      findings_.size() == 1
          ? tr("The checks ended: 1 finding")
          : tr("The checks ended: %1 findings").arg(formatCount(findings_.size()));
  const std::optional<Finding> current = panel_->current();
  emit noted(by != 0 && current ? ended + QStringLiteral(" · ") + sentenceOf(*current) : ended);
}

double FindingsFlow::usualReach() const {
  CheckOptions options = panel_->checks().options();
  options.scatter = limits().scatter;
  const std::shared_ptr<const PointDistances> now = parts_.distances.now();
  if (!unit_ && now) unit_ = exactness(*now, spacing(), options); // of all points
  return options.pointReach * unit_.value_or(spacing());
}

double FindingsFlow::sensitivity() const {
  return panel_->checks().options().sensitivity;
}

void FindingsFlow::setSensitivity(double sensitivity) {
  std::map<std::string, double> chosen = panel_->checks().chosen();
  chosen.erase("sensitivity");
  if (sensitivity != 1) chosen["sensitivity"] = sensitivity;
  panel_->checks().choose(chosen);
  checkAnew();
  emit keptChanged();
}

/// What it is, its number, and the key that does something about it.
QString FindingsFlow::sentenceOf(const Finding& finding) const {
  const auto length = [this](double value) {
    return formatLength(value, parts_.document.unit(), 3).toStdString();
  };
  QString whole = shownText(describe(finding, parts_.document.skeleton(), length));
  whole[0] = whole[0].toUpper();
  const Remedy remedy = remedyOf(finding, parts_.document.skeleton(), spacing());
  const QKeySequence key = parts_.actions[remedy.action]->shortcut();
  return tr("%1: %2 %3").arg(whole, key.toString(QKeySequence::NativeText), remedy.does);
}

void FindingsFlow::showSentence() {
  const std::optional<Finding> current = panel_->current();
  const bool isThere = current && hasNodes(parts_.document.skeleton(), *current);
  panel_->showSentence(isThere ? sentenceOf(*current) : QString());
}

/// Selects what takes part, and shows it, with some of what is around it, from its best side.
void FindingsFlow::goTo(const Finding& finding) {
  const Skeleton& skeleton = parts_.document.skeleton();
  if (!hasNodes(skeleton, finding)) return;
  parts_.document.selection().set(remedyOf(finding, skeleton, spacing()).nodes);
  parts_.actOnSelected();
  const std::shared_ptr<const PointDistances> now = parts_.distances.now();
  const bool isOfNow = now && indexed_ && now->cloud() == indexed_->cloud;
  parts_.document.pointSelection().set(isOfNow ? parts_.distances.inScan(finding.points)
                                               : PointSet());
  Sight sight{.nodes = nodesOf(finding)};
  for (const NodeId id : nodesOf(finding))
    if (const auto parent = skeleton[id].parent) sight.nodes.push_back(*parent);
  if (isOfNow)
    for (const Eigen::Index point : finding.points)
      sight.places.push_back(now->cloud()->position(point));
  sight.margin =
      std::max(boundsOf(finding, skeleton).diagonal().norm() / 2, 2 * meanEdgeLength(skeleton));
  const Camera camera = parts_.view.cameraToSee(sight);
  const QString note = parts_.reveal(nodesOf(finding), sight.places, camera);
  parts_.view.flyTo(camera, focusOn(skeleton, sight));
  const QString sentence = sentenceOf(finding);
  emit noted(note.isEmpty() ? sentence : note + QStringLiteral(" · ") + sentence);
}

void FindingsFlow::toggleIgnored() {
  const std::optional<Finding> current = panel_->current();
  if (!current) {
    emit noted(tr("Choose a finding to ignore it"));
    return;
  }
  const auto isOf = [&](const Finding& other) { return isSame(other, *current); };
  if (isIgnored(*current)) {
    std::erase_if(ignored_, isOf);
    list();
    panel_->setCurrent(*current);
  } else {
    const auto at = std::ranges::find_if(findings_, isOf) - findings_.begin();
    ignored_.push_back(*current);
    list();
    if (!findings_.empty()) // the one that takes its place
      panel_->setCurrent(findings_[std::min(static_cast<std::size_t>(at), findings_.size() - 1)]);
  }
  noteOpen();
  emit keptChanged();
}

/// The command says what it will do.
void FindingsFlow::showAction() {
  const std::optional<Finding> current = panel_->current();
  QAction* action = parts_.actions["ignore_finding"];
  action->setText(current && isIgnored(*current) ? tr("Show Finding Again") : tr("Ignore Finding"));
}

void FindingsFlow::selectAll() {
  dock_->bringToFront();
  if (timer_.isActive()) refresh();
  std::vector<NodeId> nodes;
  for (const Finding& finding : findings_)
    std::ranges::copy(nodesOf(finding), std::back_inserter(nodes));
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  parts_.document.selection().set(std::move(nodes));
  if (findings_.empty()) noteNothing();
}

} // namespace espalier
