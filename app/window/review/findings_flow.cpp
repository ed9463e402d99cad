#include "app/window/review/findings_flow.h"

#include "app/window/frame/last_step.h"
#include "app/window/review/findings_text.h"
#include "core/project/work_state.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/still_so.h"
#include "ui/document/plant_document.h"
#include "ui/panels/check_form.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace espalier {
namespace {

bool hasNodes(const Skeleton& skeleton, const Finding& finding) {
  return std::ranges::all_of(nodesOf(finding), [&](NodeId id) { return skeleton.contains(id); });
}

CheckOptions twiceAsSensitive(CheckOptions limits) {
  limits.sensitivity = 2;
  return atSensitivity(limits);
}

} // namespace

FindingsFlow::FindingsFlow(const Parts& parts)
    : parts_(parts), checks_(new CheckForm(&parts.window)) {
  keepInProject({.name = "ignored_findings",
                 .text = [this] { return textOf(ignored_); },
                 .show = [this](const std::string& text) { show(text); }});
  keepInProject({.name = "check_limits",
                 .text = [this] { return textOf(checks_->chosen()); },
                 .show = [this](const std::string& text) { showLimits(text); }});
  keepInProject({.name = openFindingsName,
                 .text = [this] { return openNote_; },
                 .show = [this](const std::string& text) { openNote_ = text; }});
  connectParts();
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
  checks_->choose({});
  checks_->choose(limitsFrom(text));
  checkAnew();
}

void FindingsFlow::checkAnew() {
  isScanChecked_ = false;
  reportsOfSkeleton_.clear(); // by other limits
  reportsOfScan_.clear();
  emit limitsChanged();
  later();
}

void FindingsFlow::setWanted(bool isWanted) {
  isWanted_ = isWanted;
  parts_.distances.setWanted(ScanDistances::Use::findings, isWanted);
  if (isWanted) refresh(); // nothing was checked while nobody looked
}

void FindingsFlow::checkNow() {
  if (timer_.isActive()) refresh();
}

void FindingsFlow::connectParts() {
  PlantDocument& document = parts_.document;
  timer_.setSingleShot(true);
  timer_.setInterval(50); // [ms]: a drag is checked when it rests
  connect(&timer_, &QTimer::timeout, this, &FindingsFlow::refresh);
  connect(&document, &PlantDocument::skeletonEdited, this, [this] {
    isScanChecked_ = false;
    list(); // none may be of a node that is gone
    later();
  });
  connect(&document, &PlantDocument::skeletonReplaced, this, [this] {
    ofSkeleton_.clear();
    ofScan_.clear();
    reportsOfSkeleton_.clear();
    reportsOfScan_.clear();
    isScanChecked_ = false;
    ignored_.clear();  // a project shows its own once its skeleton is there
    openNote_.clear(); // likewise
    list();
    later();
  });
  connect(&document, &PlantDocument::scanChanged, this, [this] {
    indexed_.reset();
    ofScan_.clear();
    reportsOfScan_.clear();
    isScanChecked_ = false;
    list();
    later();
  });
  connect(&parts_.distances, &ScanDistances::changed, this, [this] {
    isScanChecked_ = false;
    unit_.reset();
    later();
  });
  connect(&job_, &JobSlot::finished, this, [this] {
    if (std::exchange(isJobOutdated_, false)) startJob();
    noteOpen();
    emit checked();
  });
  connect(&job_, &JobSlot::failed, this, &FindingsFlow::noted);
  connect(checks_, &CheckForm::changed, this, [this] {
    checkAnew();
    emit keptChanged();
  });
}

void FindingsFlow::keepStillSo(std::vector<Finding>& now, std::vector<Report>& reports, StepId step,
                               const std::function<std::vector<Finding>()>& weaker,
                               const PointsNow* points) {
  std::vector<Finding> gone;
  for (const Report& before : reports)
    if (std::ranges::none_of(now, [&](const Finding& one) { return isSame(one, before.finding); }))
      gone.push_back(before.finding);
  if (!gone.empty())
    std::ranges::move(stillSo(gone, now, weaker(), points), std::back_inserter(now));
  std::vector<Report> from;
  for (const Finding& finding : now) {
    const auto before = std::ranges::find_if(
        reports, [&](const Report& report) { return isSame(report.finding, finding); });
    from.push_back(before != reports.end() ? *before : Report{finding, step});
  }
  reports = std::move(from);
}

/// What a step brought about is no more once that is undone, however much of it there was before.
void FindingsFlow::forgetUndone() {
  const QUndoStack& stack = parts_.document.undoStack();
  std::set<StepId> undone;
  for (int i = stack.index(); i < stack.count(); ++i)
    undone.insert(parts_.document.step(i).id);
  const auto isUndone = [&](const Report& report) { return undone.contains(report.step); };
  std::erase_if(reportsOfSkeleton_, isUndone);
  std::erase_if(reportsOfScan_, isUndone);
}

void FindingsFlow::later() {
  if (isWanted_) timer_.start();
}

void FindingsFlow::refresh() {
  timer_.stop();
  forgetUndone();
  constexpr std::size_t most = 4000; // nodes that are checked in a few ms
  const Skeleton& skeleton = parts_.document.skeleton();
  isCheckedAtOnce_ = skeleton.size() <= most;
  if (isCheckedAtOnce_) {
    ofSkeleton_ = check(skeleton, spacing(), limits());
    keepStillSo(ofSkeleton_, reportsOfSkeleton_, lastStepOf(parts_.document),
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
       options = limits(), reportsOfSkeleton = reportsOfSkeleton_, reportsOfScan = reportsOfScan_,
       step = lastStepOf(parts_.document),
       skeleton = parts_.document.skeleton()](const Progress& progress) {
        Found found{.reportsOfSkeleton = reportsOfSkeleton, .indexed = indexed};
        if (!isCheckedAtOnce) {
          found.ofSkeleton = check(skeleton, spacing, options);
          keepStillSo(*found.ofSkeleton, found.reportsOfSkeleton, step,
                      [&] { return check(skeleton, spacing, twiceAsSensitive(options)); });
        }
        if (!distances) return found;
        const std::shared_ptr<const PointCloud>& cloud = distances->cloud();
        if (found.indexed && found.indexed->cloud == cloud) // else points are others
          found.reportsOfScan = reportsOfScan;
        if (!found.indexed || found.indexed->cloud != cloud)
          found.indexed =
              std::make_shared<const Indexed>(Indexed{cloud, SpatialIndex(cloud->positions())});
        found.ofScan = checkAgainstScan(skeleton, *distances, found.indexed->index, spacing,
                                        options, progress);
        const auto weaker = [&] {
          return checkAgainstScan(skeleton, *distances, found.indexed->index, spacing,
                                  twiceAsSensitive(options), progress);
        };
        const PointsNow points{.skeleton = skeleton,
                               .distances = *distances,
                               .spacing = spacing,
                               .reach =
                                   options.pointReach * exactness(*distances, spacing, options)};
        keepStillSo(found.ofScan, found.reportsOfScan, step, weaker, &points);
        return found;
      },
      [this](Found found) { take(std::move(found)); });
  emit changed(); // it is checked
}

void FindingsFlow::take(Found found) {
  if (found.ofSkeleton) {
    ofSkeleton_ = std::move(*found.ofSkeleton);
    reportsOfSkeleton_ = std::move(found.reportsOfSkeleton);
  }
  const std::shared_ptr<const PointDistances> now = parts_.distances.now();
  if (now && found.indexed && now->cloud() == found.indexed->cloud) {
    reportsOfScan_ = std::move(found.reportsOfScan);
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
  CheckOptions options = checks_->options();
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
  emit changed();
}

void FindingsFlow::noteOpen() {
  const bool isKnown =
      isWanted_ && isAllChecked() && !timer_.isActive() && !parts_.document.skeleton().isEmpty();
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

void FindingsFlow::stopIgnoring(const Finding& finding) {
  std::erase_if(ignored_, [&](const Finding& other) { return isSame(other, finding); });
  list();
  noteOpen();
  emit keptChanged();
}

bool FindingsFlow::arePointsOfNow() const {
  const std::shared_ptr<const PointDistances> now = parts_.distances.now();
  return now && indexed_ && now->cloud() == indexed_->cloud;
}

double FindingsFlow::usualReach() const {
  CheckOptions options = checks_->options();
  options.scatter = limits().scatter;
  const std::shared_ptr<const PointDistances> now = parts_.distances.now();
  if (!unit_ && now) unit_ = exactness(*now, spacing(), options); // of all points
  return options.pointReach * unit_.value_or(spacing());
}

double FindingsFlow::sensitivity() const {
  return checks_->options().sensitivity;
}

void FindingsFlow::setSensitivity(double sensitivity) {
  std::map<std::string, double> chosen = checks_->chosen();
  chosen.erase("sensitivity");
  if (sensitivity != 1) chosen["sensitivity"] = sensitivity;
  checks_->choose(chosen);
  checkAnew();
  emit keptChanged();
}

} // namespace espalier
