#include "app/window/review/suspects_flow.h"

#include "app/window/frame/action_set.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/review/asking_flow.h"
#include "app/window/review/finding_remedy.h"
#include "app/window/review/findings_flow.h"
#include "core/base/error.h"
#include "core/doubt/doubts_along.h"
#include "core/doubt/finding_gain.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"
#include "ui/document/doubt_text.h"
#include "ui/document/finding_title.h"
#include "ui/document/plant_document.h"
#include "ui/panels/check_form.h"
#include "ui/panels/suspects_panel.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QMenu>
#include <QScopedValueRollback>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

namespace espalier {
namespace {

constexpr int allKinds = -1; // beside those of Suspect
constexpr int ignoredKind = findingKinds + doubtKinds;

std::vector<NodeId> placesOf(const Doubt& doubt) {
  return doubt.nodes.empty() ? std::vector<NodeId>{doubt.node} : doubt.nodes;
}

} // namespace

bool SuspectsFlow::showsIgnored() const {
  return kind_ == ignoredKind;
}

SuspectsFlow::SuspectsFlow(Parts parts) : parts_(std::move(parts)), kind_(allKinds) {
  addActions();
  makePanel();
  connectParts();
  refresh();
  showAction();
}

void SuspectsFlow::addActions() {
  parts_.actions.beginSection(tr("What May Be Wrong"));
  const auto add = [this](const char* id, const QString& text, const QString& help,
                          const QKeySequence& keys, const std::function<void()>& act) {
    return parts_.actions.add({.id = id, .text = text, .help = help, .keys = keys}, act);
  };
  add("next_finding", tr("Next Finding or Doubt"),
      tr("Goes on to the next place that may be wrong, what matters most first"), Qt::Key_F4,
      [this] { step(1); });
  add("previous_finding", tr("Previous Finding or Doubt"),
      tr("Goes back to the place before that may be wrong"), QKeySequence(Qt::SHIFT | Qt::Key_F4),
      [this] { step(-1); });
  add("ignore_finding", tr("Ignore Finding"),
      tr("Leaves what is chosen out of the list, or shows it again"),
      QKeySequence(Qt::CTRL | Qt::Key_F4), [this] { toggleIgnored(); });
  add("select_findings", tr("All Findings"), tr("Selects the nodes of all findings of the checks"),
      {}, [this] { selectAll(); });
  add("check_limits", tr("Limits of the Checks"),
      tr("Shows or hides from where on the checks report something"), {}, [this] {
        const bool isOpen = dock_->isShown() && parts_.findings.checks().isOpen();
        dock_->bringToFront();
        parts_.findings.checks().setOpen(!isOpen);
      });
  const auto addListed = [&](const char* id, Listed listed, const QString& text,
                             const QString& brief, const QString& help) {
    add(id, text, help, {}, [this, listed] { listOnly(listed); })->setIconText(brief);
  };
  addListed("list_all", Listed::all, tr("List All That May Be Wrong"), tr("Whole plant"),
            tr("Lists findings and doubts of the whole plant"));
  addListed("list_in_view", Listed::inView, tr("List What Is in the View"), tr("In the view"),
            tr("Lists only findings and doubts of what is in the view now"));
  addListed("list_selected", Listed::selected, tr("List What Is Selected"), tr("Selected"),
            tr("Lists only findings and doubts of the nodes that are selected now"));
  addListed("list_axes", Listed::axes, tr("List the Selected Axes"), tr("Selected axes"),
            tr("Lists only findings and doubts of the axes that selected nodes are on"));
  parts_.actions.place("review/findings",
                       {"next_finding", "previous_finding", "ignore_finding", "check_limits"});
  parts_.actions.place("review/findings", [this](QMenu& menu) {
    QMenu* listed = menu.addMenu(tr("What Is Listed"));
    for (const char* id : {"list_all", "list_in_view", "list_selected", "list_axes"})
      listed->addAction(parts_.actions[id]);
  });
  parts_.actions.place("select/findings", {"select_findings"});
}

void SuspectsFlow::makePanel() {
  const auto at = [this](const char* id) { return parts_.actions[id]; };
  panel_ = new SuspectsPanel(
      parts_.document,
      {.ask = at("ask_doubts"),
       .answers = {at("answer_1"), at("answer_2"), at("answer_3"), at("answer_4")},
       .none = at("answer_none"),
       .skip = at("skip_doubt"),
       .takeBack = at("take_back_answer"),
       .decideRest = at("decide_rest"),
       .previous = at("previous_finding"),
       .next = at("next_finding"),
       .ignore = at("ignore_finding"),
       .places = {at("list_all"), at("list_in_view"), at("list_selected"), at("list_axes")}},
      parts_.findings.checks(), [this](const Suspect& suspect) { return textOf(suspect); });
  dock_ = addDock(
      new PanelDock({parts_.actions, parts_.settings, parts_.window},
                    {.id = "findings",
                     .title = tr("Findings"),
                     .text = tr("Findings and Doubts Panel"),
                     .help = tr("Shows or hides what the checks found, and what is in doubt"),
                     .keys = Qt::Key_F8,
                     .manual = "checks.md"},
                    besideThePlant, panel_, this));
  at("show_findings")->setShortcuts({Qt::Key_F8, QKeySequence(Qt::SHIFT | Qt::Key_F2)});
}

void SuspectsFlow::connectParts() {
  PlantDocument& document = parts_.document;
  agreementTimer_.setSingleShot(true);
  connect(&agreementTimer_, &QTimer::timeout, this, &SuspectsFlow::refreshAgreement);
  connect(&parts_.findings, &FindingsFlow::changed, this, &SuspectsFlow::refresh);
  connect(&parts_.findings, &FindingsFlow::checked, this, [this] {
    refreshTexts();
    answer();
  });
  connect(&parts_.doubts, &DoubtsFlow::changed, this, [this] {
    refresh(); // what is listed first: a question beside it comes and goes
    parts_.asking.followDoubts();
    if (dock_->isShown()) agreementTimer_.start(0);
  });
  connect(&parts_.asking, &AskingFlow::asked, this, &SuspectsFlow::showAsked);
  connect(&parts_.asking, &AskingFlow::begun, dock_, &PanelDock::bringToFront);
  connect(&parts_.asking, &AskingFlow::begun, this, &SuspectsFlow::leaveFinding);
  parts_.asking.askOnlyAbout([this](const Doubt& doubt) { return isListed(doubt); });
  connect(&document.selection(), &Selection::changed, this, [this] { awaitedStep_ = 0; });
  connect(&document, &PlantDocument::skeletonEdited, this, [this] { awaitedStep_ = 0; });
  connect(&document, &PlantDocument::skeletonReplaced, this, [this] {
    wasWhole_ = false;
    listed_ = Listed::all;
    kind_ = allKinds;
    place_.reset();
    refresh();
  });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged})
    connect(&document, signal, this, [this] { cloud_.reset(); });
  connect(&document, &PlantDocument::unitChanged, this, [this] { refresh(); });
  connect(dock_, &PanelDock::shown, this, [this](bool isShown) {
    parts_.doubts.setWanted(DoubtsFlow::Use::panel, isShown);
    parts_.findings.setWanted(isShown);
    isAwaited_ = false;
    wasWhole_ = false;
    place_.reset();
    refresh();
    if (isShown) agreementTimer_.start(0);
  });
  connect(panel_, &SuspectsPanel::chosen, this, &SuspectsFlow::choose);
  connect(panel_, &SuspectsPanel::kindChosen, this, [this](int kind) {
    kind_ = kind;
    place_.reset();
    refresh();
  });
  connect(panel_, &SuspectsPanel::currentChanged, this, [this] {
    if (isRefreshing_) return;
    const auto row = panel_->current();
    current_ = row ? std::optional(whatOf(panel_->suspects()[*row])) : std::nullopt;
    keepPlace();
    refreshTexts();
    showAction();
  });
}

bool SuspectsFlow::isListedPlace(const std::vector<NodeId>& nodes) const {
  return listed_ == Listed::all || std::ranges::any_of(nodes, [this](NodeId id) {
           return indexOf(id) >= isIn_.size() || isIn_[indexOf(id)];
         });
}

bool SuspectsFlow::isListed(const Doubt& doubt) const {
  const bool isOfKind = kind_ < findingKinds || kind_ == ignoredKind ||
                        kind_ == findingKinds + static_cast<int>(doubt.kind);
  return isOfKind && isListedPlace(placesOf(doubt));
}

const Finding& SuspectsFlow::findingOf(const Suspect& suspect) const {
  return (suspect.isIgnored() ? parts_.findings.ignored()
                              : parts_.findings.findings())[suspect.number];
}

const Doubt& SuspectsFlow::doubtOf(const Suspect& suspect) const {
  return (suspect.isIgnored() ? parts_.doubts.ignored() : parts_.doubts.doubts())[suspect.number];
}

SuspectsFlow::What SuspectsFlow::whatOf(const Suspect& suspect) const {
  return suspect.isDoubt() ? What(doubtOf(suspect)) : What(findingOf(suspect));
}

/// Those of the part of the plant that is listed, what matters most first.
std::vector<Suspect> SuspectsFlow::suspects(bool areIgnored) const {
  using Sort = Suspect::Sort;
  const std::vector<Finding>& findings =
      areIgnored ? parts_.findings.ignored() : parts_.findings.findings();
  const std::vector<Doubt>& doubts = areIgnored ? parts_.doubts.ignored() : parts_.doubts.doubts();
  const std::vector<FindingGain> gains =
      gainsOf(findings, parts_.document.skeleton(),
              areIgnored ? parts_.findings.findings() : parts_.findings.ignored());
  std::vector<Suspect> all;
  for (std::size_t i = 0; i < findings.size(); ++i)
    if (isListedPlace(nodesOf(findings[i])) && (areIgnored || !isIgnoredAsDoubt(i)))
      all.push_back({areIgnored ? Sort::ignoredFinding : Sort::finding, i,
                     static_cast<int>(findings[i].kind), gains[i].length, gains[i].wrong,
                     gains[i].gain, areIgnored ? std::nullopt : listedTwin(i)});
  const std::size_t before = areIgnored ? parts_.doubts.doubts().size() : 0; // of their numbers
  for (std::size_t i = 0; i < doubts.size(); ++i)
    if (isListedPlace(placesOf(doubts[i])))
      all.push_back({areIgnored ? Sort::ignoredDoubt : Sort::doubt, i,
                     findingKinds + static_cast<int>(doubts[i].kind), doubts[i].length,
                     doubts[i].wrong(), doubts[i].gain, findingAbout(before + i)});
  if (isSearching() && current_ && place_) // what was just edited stays in its place
    for (Suspect& one : all)
      if (!one.isIgnored() && isSame(one, *current_)) one.gain = place_->gain;
  std::ranges::stable_sort(all, std::greater(), &Suspect::gain);
  return all;
}

/// A finding and a doubt about the same points are one place.
void SuspectsFlow::findTwins() {
  if (parts_.findings.arePointsOfNow()) cloud_ = parts_.distances.now()->cloud();
  std::vector<Doubt> doubts = parts_.doubts.doubts();
  std::ranges::copy(parts_.doubts.ignored(), std::back_inserter(doubts));
  const std::vector<Finding>& findings = parts_.findings.findings();
  twins_.assign(findings.size(), std::nullopt);
  if (cloud_) twins_ = doubtsAlong(findings, doubts, *cloud_, 4 * spacing());
}

bool SuspectsFlow::isIgnoredAsDoubt(std::size_t finding) const {
  return twins_[finding] && *twins_[finding] >= parts_.doubts.doubts().size();
}

/// The doubt that is listed for a finding.
std::optional<std::size_t> SuspectsFlow::listedTwin(std::size_t finding) const {
  const std::optional<std::size_t> twin = twins_[finding];
  const bool isListed = twin && isListedPlace(placesOf(parts_.doubts.doubts()[*twin]));
  return isListed ? twin : std::nullopt;
}

std::optional<std::size_t> SuspectsFlow::findingAbout(std::size_t doubt) const {
  const auto at = std::ranges::find(twins_, std::optional(doubt));
  if (at == twins_.end()) return std::nullopt;
  return static_cast<std::size_t>(at - twins_.begin());
}

void SuspectsFlow::refresh() {
  if (!dock_->isShown()) return panel_->show({});
  findTwins();
  wasWhole_ = wasWhole_ || !isSearching();
  count_ = parts_.doubts.doubts().size() +
           static_cast<std::size_t>(
               std::ranges::count(twins_, false, &std::optional<std::size_t>::has_value));
  std::vector<Suspect> all = suspects(false);
  std::vector<Suspect> ignored = suspects(true);
  ignoredCount_ = ignored.size();
  if (kind_ == ignoredKind && ignored.empty()) kind_ = allKinds;
  {
    const QScopedValueRollback refreshing(isRefreshing_, true);
    showKinds(all, ignored.size());
    panel_->showPlace(static_cast<std::size_t>(listed_));
    if (kind_ == allKinds) std::erase_if(all, std::mem_fn(&Suspect::isListedAsDoubt));
    if (kind_ == ignoredKind) all = std::move(ignored);
    if (kind_ >= 0 && kind_ != ignoredKind)
      std::erase_if(all, [this](const Suspect& one) { return one.kind != kind_; });
    panel_->show(std::move(all));
    const auto row = current_ ? rowOf(*current_) : std::nullopt;
    if (row) current_ = whatOf(panel_->suspects()[*row]); // as it is now
    if (!row && !isSearching()) current_.reset();         // else it may be found again
    panel_->setCurrent(row);
    keepPlace();
  }
  refreshTexts();
  showAction();
  if (awaitedStep_ != 0) answer();
}

void SuspectsFlow::showKinds(const std::vector<Suspect>& all, std::size_t ignored) {
  std::map<int, std::size_t> counts;
  for (const Suspect& suspect : all)
    ++counts[suspect.kind];
  if (kind_ >= 0 && kind_ != ignoredKind) counts.try_emplace(kind_, 0U); // that is chosen
  std::vector<SuspectsPanel::Kind> kinds;
  const auto add = [&](int kind, const QString& title, std::size_t count) {
    kinds.push_back({tr("%1 (%2)").arg(title, formatCount(count)), kind});
  };
  const auto asDoubts = std::ranges::count_if(all, std::mem_fn(&Suspect::isListedAsDoubt));
  if (!counts.empty() || ignored > 0)
    add(allKinds, tr("All kinds"), all.size() - static_cast<std::size_t>(asDoubts));
  for (const auto& [kind, count] : counts)
    add(kind,
        kind < findingKinds ? titleOf(static_cast<Finding::Kind>(kind))
                            : nameOfOne(static_cast<Doubt::Kind>(kind - findingKinds)),
        count);
  if (ignored > 0) add(ignoredKind, tr("Ignored"), ignored);
  panel_->showKinds(kinds, kind_);
}

bool SuspectsFlow::isSame(const Suspect& one, const What& what) const {
  if (one.isDoubt() != std::holds_alternative<Doubt>(what)) return false;
  const double near = 4 * parts_.document.scale().spacing;
  return one.isDoubt() ? espalier::isSame(doubtOf(one), std::get<Doubt>(what), near)
                       : espalier::isSame(findingOf(one), std::get<Finding>(what));
}

std::optional<std::size_t> SuspectsFlow::rowOf(const What& what) const {
  const std::vector<Suspect>& rows = panel_->suspects();
  const auto at = std::ranges::find_if(rows, [&](const Suspect& one) { return isSame(one, what); });
  if (at == rows.end()) return std::nullopt;
  return static_cast<std::size_t>(at - rows.begin());
}

void SuspectsFlow::keepPlace() {
  if (const auto row = panel_->current()) place_ = {*row, panel_->suspects()[*row].gain};
}

/// The row that one goes to from where one is; where that is mended, from where it was.
std::size_t SuspectsFlow::rowFrom(int by) const {
  const std::vector<Suspect>& rows = panel_->suspects();
  const std::size_t last = rows.size() - 1;
  const std::size_t one = by > 0 ? 1 : last;
  if (const auto at = panel_->current()) return (*at + one) % rows.size();
  if (!place_) return by > 0 ? 0 : last;
  const std::ranges::greater more;
  const auto first = std::ranges::lower_bound(rows, place_->gain, more, &Suspect::gain);
  const auto end = std::ranges::upper_bound(rows, place_->gain, more, &Suspect::gain);
  const auto next = std::clamp(place_->row, static_cast<std::size_t>(first - rows.begin()),
                               static_cast<std::size_t>(end - rows.begin()));
  return (next + (by > 0 ? 0 : last)) % rows.size();
}

bool SuspectsFlow::isSearching() const {
  return parts_.findings.isBusy() || parts_.doubts.isBusy();
}

void SuspectsFlow::step(int by) {
  dock_->bringToFront();
  parts_.findings.checkNow();
  const std::size_t count = panel_->suspects().size();
  // What comes first is known once all is; an edit later does not hold up who goes through the
  // list.
  if (count == 0 || (!wasWhole_ && isSearching())) {
    noteNothing();
    awaitedStep_ = isAwaited_ ? by : 0;
    return;
  }
  awaitedStep_ = 0;
  const std::size_t next = rowFrom(by);
  panel_->setCurrent(next);
  choose(next);
}

void SuspectsFlow::noteNothing() {
  const bool hasSkeleton = !parts_.document.skeleton().isEmpty();
  const bool isChecked = parts_.findings.isAllChecked();
  isAwaited_ = hasSkeleton && (!isChecked || parts_.doubts.isBusy());
  emit noted(isAwaited_ ? noteText() : titleText());
}

/// To who has asked for a place before there were any, and done nothing else since.
void SuspectsFlow::answer() {
  if (!isAwaited_ || !parts_.findings.isAllChecked()) return;
  if (awaitedStep_ != 0 && !wasWhole_ && isSearching()) return;
  const int by = std::exchange(awaitedStep_, 0);
  isAwaited_ = false;
  if (panel_->suspects().empty()) {
    noteNothing(); // or doubts are looked for still
    awaitedStep_ = isAwaited_ ? by : 0;
    return;
  }
  if (by != 0) step(by);
  const QString ended = tr("The checks ended: %1").arg(titleText());
  const bool isAtFinding = by != 0 && current_ && std::holds_alternative<Finding>(*current_);
  emit noted(isAtFinding ? ended + QStringLiteral(" · ") + sentenceOf(*current_) : ended);
}

/// A finding is gone to, a doubt asked about.
void SuspectsFlow::choose(std::size_t row) {
  const What what = whatOf(panel_->suspects()[row]);
  current_ = what;
  if (std::holds_alternative<Doubt>(what)) return parts_.asking.askAbout(std::get<Doubt>(what));
  parts_.asking.stopAsking();
  goTo(std::get<Finding>(what));
}

void SuspectsFlow::showAsked(const std::optional<Doubt>& doubt, bool isByHand) {
  if (doubt) {
    current_ = *doubt;
    refresh(); // doubts may just have changed
  }
  panel_->showQuestion(doubt, isByHand);
}

/// Selects what takes part, and shows it, with some of what is around it, from its best side.
void SuspectsFlow::goTo(const Finding& finding) {
  const Skeleton& skeleton = parts_.document.skeleton();
  const std::vector<NodeId> nodes = nodesOf(finding);
  if (!std::ranges::all_of(nodes, [&](NodeId id) { return skeleton.contains(id); })) return;
  parts_.document.selection().set(remedyOf(finding, skeleton, spacing()).nodes);
  parts_.actOnSelected();
  const bool isOfNow = parts_.findings.arePointsOfNow();
  parts_.document.pointSelection().set(isOfNow ? parts_.distances.inScan(finding.points)
                                               : PointSet());
  nodesOfFinding_ = parts_.document.selection().nodes();
  pointsOfFinding_ = parts_.document.pointSelection().points();
  Sight sight{.nodes = nodes};
  for (const NodeId id : nodes)
    if (const auto parent = skeleton[id].parent) sight.nodes.push_back(*parent);
  if (isOfNow)
    for (const Eigen::Index point : finding.points)
      sight.places.push_back(parts_.distances.now()->cloud()->position(point));
  sight.margin =
      std::max(boundsOf(finding, skeleton).diagonal().norm() / 2, 2 * meanEdgeLength(skeleton));
  const Camera camera = parts_.view.cameraToSee(sight);
  const QString note = parts_.reveal(nodes, sight.places, camera);
  parts_.view.flyTo(camera, focusOn(skeleton, sight));
  const QString sentence = sentenceOf(finding);
  emit noted(note.isEmpty() ? sentence : note + QStringLiteral(" · ") + sentence);
}

/// Keys would act on it where something else is looked at.
void SuspectsFlow::leaveFinding() {
  if (parts_.document.selection().nodes() == std::exchange(nodesOfFinding_, {}))
    parts_.document.selection().clear();
  if (parts_.document.pointSelection().points() == std::exchange(pointsOfFinding_, {}))
    parts_.document.pointSelection().clear();
}

void SuspectsFlow::selectAll() {
  dock_->bringToFront();
  parts_.findings.checkNow();
  std::vector<NodeId> nodes;
  for (const Finding& finding : parts_.findings.findings())
    std::ranges::copy(nodesOf(finding), std::back_inserter(nodes));
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.empty()) return noteNothing();
  parts_.document.selection().set(std::move(nodes));
}

/// What is seen or selected now is listed until one chooses again, wherever one goes meanwhile.
void SuspectsFlow::listOnly(Listed listed) {
  const Skeleton& skeleton = parts_.document.skeleton();
  const std::vector<NodeId>& selected = parts_.document.selection().nodes();
  panel_->showPlace(static_cast<std::size_t>(listed_)); // until it is done
  const bool needsSelected = listed == Listed::selected || listed == Listed::axes;
  if (needsSelected && selected.empty())
    throw Error(tr("select nodes first: what is selected now is listed").toStdString());
  const std::vector<NodeId> nodes =
      listed == Listed::inView ? parts_.view.nodesInside(QRectF(parts_.view.rect()), Depth::through)
      : listed == Listed::axes ? axesThrough(skeleton, selected)
                               : selected;
  listed_ = listed;
  isIn_.assign(skeleton.idEnd(), false);
  for (const NodeId id : nodes)
    isIn_[indexOf(id)] = true;
  place_.reset();
  dock_->bringToFront();
  refresh();
}

} // namespace espalier
