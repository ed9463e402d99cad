// Where the walk of the review leads, and what is shown there.
#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/frame/ignoring_steps.h"
#include "app/window/frame/key_hints.h"
#include "app/window/frame/panel_dock.h"
#include "app/window/review/error_reason_text.h"
#include "app/window/review/expected_errors_flow.h"
#include "app/window/review/looked_at.h"
#include "app/window/review/review_flow.h"
#include "core/skeleton/review_coverage.h"
#include "ui/document/plant_document.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QSettings>

#include <algorithm>
#include <iterator>
#include <utility>

namespace espalier {

/// By what is known of errors; points that were taken for no wood are none any more.
std::vector<ReviewStop> ReviewFlow::stops() const {
  const ExpectedErrors* known = parts_.errors.now();
  std::vector<ReviewStop> all = reviewStops(parts_.document.skeleton(), known, order_);
  const auto isOver = [&](std::size_t i) { return parts_.isIgnored(known->clusters[i]); };
  std::erase_if(all, [&](ReviewStop& stop) {
    return std::erase_if(stop.clusters, isOver) > 0 && stop.clusters.empty();
  });
  const auto isDoubted = [&](std::size_t i) {
    return std::ranges::any_of(
        doubted_, [&](const Finding& doubted) { return isSame(doubted, known->clusters[i]); });
  };
  for (ReviewStop& stop : all)
    stop.isDoubtful = stop.isAtPoints() && std::ranges::all_of(stop.clusters, isDoubted);
  return all;
}

/// At points, at what is selected, or where one was last.
std::optional<std::size_t> ReviewFlow::placeIn(const std::vector<ReviewStop>& all) const {
  const std::vector<NodeId>& chosen = parts_.document.selection().nodes();
  if (!chosen.empty()) return stopOf(all, chosen.back());
  const ExpectedErrors* known = parts_.errors.now();
  const auto isHere = [&](const ReviewStop& stop) {
    return std::ranges::any_of(stop.clusters, [&](std::size_t i) {
      return isSame(known->clusters[i], atPoints_.front());
    });
  };
  if (!atPoints_.empty())
    if (const auto here = std::ranges::find_if(all, isHere); here != all.end())
      return static_cast<std::size_t>(here - all.begin());
  const Skeleton& skeleton = parts_.document.skeleton();
  const auto left = std::ranges::find_if(at_, [&](NodeId id) { return skeleton.contains(id); });
  return left != at_.end() ? stopOf(all, *left) : std::nullopt;
}

void ReviewFlow::step(WalkTo to, WalkDirection direction) {
  if (stepIfAny(to, direction)) return;
  if (to == WalkTo::toDo || to == WalkTo::notReviewed)
    emit noted(tr("All is reviewed: the structure can be signed"));
  else if (to == WalkTo::openEnd)
    emit noted(tr("Every end is reviewed"));
  else if (to == WalkTo::branching)
    emit noted(tr("Every branching is reviewed"));
}

/// @return false: there is nothing of the kind
bool ReviewFlow::stepIfAny(WalkTo to, WalkDirection direction) {
  dock_->bringToFront();
  if (parts_.errors.now() == nullptr && parts_.errors.isBusy()) {
    awaited_ = {to, direction};
    emit noted(tr("Looking where errors are likely…"));
    return true;
  }
  const std::vector<ReviewStop> all = stops();
  const std::vector<NodeId>& chosen = parts_.document.selection().nodes();
  const std::optional<std::size_t> from = placeIn(all);
  const bool isElsewhere = !chosen.empty() && chosen != at_; // one has clicked: begin there
  const std::optional<std::size_t> next =
      isElsewhere && from && to == WalkTo::anyStop
          ? from
          : walk(parts_.document.skeleton(), all, from, to, direction);
  if (next) goTo(all, *next);
  return next.has_value();
}

/// What was asked for before errors were known.
void ReviewFlow::goOnWaiting() {
  if (parts_.errors.now() == nullptr && parts_.errors.isBusy()) return; // not yet
  const auto awaited = std::exchange(awaited_, std::nullopt);
  if (!awaited) return;
  emit noted({}); // it is over
  step(awaited->first, awaited->second);
}

/// Begins with the first that is to do, in the order that is chosen.
void ReviewFlow::chooseOrder(bool isByError) {
  order_ = isByError ? WalkOrder::byExpectedError : WalkOrder::alongPlant;
  parts_.settings.setValue("review/riskiest_first", isByError);
  if (!dock_->isInFront() || parts_.document.skeleton().isEmpty()) return;
  at_.clear();
  atPoints_.clear();
  parts_.document.selection().clear();
  step(WalkTo::toDo);
  if (isByError && parts_.document.scan() == nullptr)
    emit noted(tr("Without a scan nothing is known of errors: the walk goes along the plant"));
}

/// How many stops are to do: those of before change as points and nodes are dealt with.
QString ReviewFlow::leftText(const std::vector<ReviewStop>& all) const {
  const auto isToDo = [this](NodeId id) {
    return parts_.document.skeleton()[id].review.state == ReviewState::toDo;
  };
  const auto left = static_cast<std::size_t>(std::ranges::count_if(all, [&](const ReviewStop& one) {
    return one.isAtPoints() ? !one.isDoubtful : std::ranges::any_of(one.nodes, isToDo);
  }));
  return left == 0   ? tr("No stop left")
         : left == 1 ? tr("1 stop left")
                     : tr("%1 stops left").arg(formatCount(left));
}

void ReviewFlow::describe(const std::vector<ReviewStop>& all, const ReviewStop& stop) {
  placeText_ = leftText(all);
  if (stop.isAtPoints())
    placeText_ += tr(". Here: no wood");
  else if (stop.isClean)
    placeText_ += tr(". Here: clean");
  else if (parts_.errors.now() != nullptr && stop.length > 0)
    placeText_ += tr(". Here: risk %1 %").arg(qRound(100 * stop.wrong / stop.length));
  whyText_ = whyRisky(stop);
}

/// After an edit, an undo, or other errors: the stop one is at may be another, and others be left.
void ReviewFlow::describeAgain() {
  if (!dock_->isInFront() || (at_.empty() && atPoints_.empty())) return;
  const std::vector<ReviewStop> all = stops();
  if (const std::optional<std::size_t> here = placeIn(all)) {
    describe(all, all[*here]);
  } else {
    placeText_ = leftText(all);
    whyText_.clear();
  }
  showPlace();
}

void ReviewFlow::goTo(const std::vector<ReviewStop>& all, std::size_t index) {
  const ReviewStop& stop = all[index];
  describe(all, stop);
  if (stop.isAtPoints()) return goToPoints(stop);
  const bool wasAtPoints = !std::exchange(atPoints_, {}).empty();
  if (wasAtPoints) parts_.document.pointSelection().clear();
  at_ = stop.nodes;
  parts_.document.selection().set(at_);
  showPlace(); // the same nodes may be another stop of more
  const QString note = frame(at_);
  if (wasAtPoints || !note.isEmpty()) emit noted(note);
}

/// What speaks most for an error there, or what to do at points; empty: nothing is known of it.
QString ReviewFlow::whyRisky(const ReviewStop& stop) const {
  if (stop.isAtPoints())
    return withKeys(
        tr("No wood is near these points: add some, or press {mark_reviewed} if there is "
           "none"),
        parts_.actions);
  if (stop.isClean) return {};
  const std::optional<ErrorEvidence> evidence = parts_.errors.riskiestOf(stop.nodes);
  const QString reasons =
      evidence ? textOfReasons(*evidence, parts_.document.scale().spacing, parts_.document.unit())
               : QString();
  return reasons.isEmpty() ? reasons : tr("The riskiest wood of this stop: %1").arg(reasons);
}

void ReviewFlow::goToPoints(const ReviewStop& stop) {
  parts_.document.selection().clear();
  atPoints_.clear();
  PointSet points;
  for (const std::size_t i : stop.clusters) {
    atPoints_.push_back(parts_.errors.now()->clusters[i]);
    points = points | parts_.errors.pointsOf(atPoints_.back());
  }
  at_ = {atPoints_.front().node};
  parts_.document.pointSelection().set(points);
  showPlace();
  const QString note = frame({}, placesAt());
  emit noted(note.isEmpty() ? whyText_ : note);
}

bool ReviewFlow::isAtPoints() const {
  return !atPoints_.empty() && parts_.document.selection().isEmpty();
}

std::vector<Eigen::Vector3d> ReviewFlow::placesAt() const {
  std::vector<Eigen::Vector3d> places;
  const Scan* scan = parts_.document.scan();
  if (scan == nullptr) return places;
  for (const Finding& cluster : atPoints_)
    for (const Eigen::Index point : parts_.errors.pointsOf(cluster).points())
      places.push_back(scan->cloud()->position(point));
  return places;
}

/// Takes the points one is at for no wood: they are no finding any more.
void ReviewFlow::takePoints() {
  PointSet points;
  for (const Finding& cluster : atPoints_)
    points = points | parts_.errors.pointsOf(cluster);
  if (points.isEmpty() || !(points - PointSet::of(parts_.view.pointsShown())).isEmpty())
    return emit noted(withKeys(tr("Nothing is marked, as not all of these points are shown: choose "
                                  "View > Layers > Points   {show_all} shows what is hidden"),
                               parts_.actions));
  const std::vector<Eigen::Vector3d> places = placesAt();
  if (!areSeen({.skeleton = parts_.document.skeleton(),
                .hidden = parts_.hidden(),
                .views = {&parts_.view, &parts_.editing.activeView()}},
               places)) {
    const QString note = frame({}, places);
    emit noted(tr("Nothing is marked yet, as not all of these points were seen: now they are") +
               (note.isEmpty() ? note : QStringLiteral("   ") + note));
    return;
  }
  const std::vector<ReviewStop> all = stops();
  const auto from = placeIn(all);
  const auto next = walk(parts_.document.skeleton(), all, from, WalkTo::toDo);
  const std::vector<Finding> taken = atPoints_;
  const auto take = [this, taken] {
    for (const Finding& cluster : taken)
      parts_.setIgnored(cluster, true);
  };
  const auto takeAgain = [this, take] {
    take();
    goOnAfter(false);
  };
  take();
  parts_.ignoring.add({.text = tr("Take points for no wood"),
                       .undo = [this, taken] { bringBack(taken); },
                       .redo = takeAgain});
  if (!next || next == from) return goOnAfter(false);
  const std::vector<ReviewStop> left = stops();
  const auto there = std::ranges::find_if(left, [&](const ReviewStop& stop) {
    return stop.nodes == all[*next].nodes && stop.clusters == all[*next].clusters;
  });
  if (there == left.end()) return goOnAfter(false);
  goTo(left, static_cast<std::size_t>(there - left.begin()));
}

void ReviewFlow::bringBack(const std::vector<Finding>& points) {
  for (const Finding& cluster : points)
    parts_.setIgnored(cluster, false);
  const std::vector<ReviewStop> all = stops();
  const ExpectedErrors* known = parts_.errors.now();
  const auto there = std::ranges::find_if(all, [&](const ReviewStop& stop) {
    return std::ranges::any_of(
        stop.clusters, [&](std::size_t i) { return isSame(known->clusters[i], points.front()); });
  });
  if (there != all.end()) goTo(all, static_cast<std::size_t>(there - all.begin()));
}

/// Shows nodes with some of what is around them, from their best side.
/// @return what else had to be shown for that; empty: nothing
QString ReviewFlow::frame(const std::vector<NodeId>& nodes,
                          const std::vector<Eigen::Vector3d>& places) {
  const Skeleton& skeleton = parts_.document.skeleton();
  Sight sight{.nodes = nodes, .places = places};
  if (sight.isEmpty()) return {};
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& place : places)
    box.extend(place);
  for (const NodeId id : nodes) {
    box.extend(skeleton[id].position);
    const std::optional<NodeId> parent = skeleton[id].parent;
    if (parent) box.extend(skeleton[*parent].position);
    if (parent && std::ranges::find(nodes, *parent) == nodes.end()) sight.nodes.push_back(*parent);
  }
  const double longest = longestStretch(skeleton);
  const double across = box.diagonal().norm();
  sight.margin = std::max(0.3 * across, 0.2 * longest);
  if (across <= longestLook * longest) // a stop is drawn as large as that allows
    sight.margin = std::min(sight.margin, 0.3 * longest);
  const Camera camera = parts_.view.cameraToSee(sight);
  std::vector<NodeId> shown = sight.nodes;
  if (!places.empty()) // where the wood that they are nearest to is hidden, they are
    for (const Finding& cluster : atPoints_)
      std::ranges::copy(parts_.errors.nodesAt(cluster), std::back_inserter(shown));
  QString note = parts_.reveal(shown, places, camera);
  parts_.view.flyTo(camera, focusOn(skeleton, sight));
  return note;
}

/// To what is to do; to what is doubtful only where one has looked at doubts before.
void ReviewFlow::goOnAfter(bool wasDoubtful) {
  if (stepIfAny(WalkTo::toDo)) return;
  const ReviewCoverage all = coverage(parts_.document.skeleton());
  const std::size_t nodes = all.nodes[static_cast<std::size_t>(ReviewState::doubtful)];
  const std::vector<ReviewStop> left = stops();
  placeText_ = leftText(left);
  whyText_.clear();
  showPlace();
  const bool hasPoints = std::ranges::any_of(left, &ReviewStop::isDoubtful);
  if (wasDoubtful || (nodes == 0 && !hasPoints)) return step(WalkTo::notReviewed);
  const QString what = nodes > 1    ? tr("%1 nodes are doubtful").arg(formatCount(nodes))
                       : nodes == 1 ? tr("1 node is doubtful")
                                    : tr("points without wood are doubtful");
  emit noted(withKeys(tr("Nothing is to do; %1: {next_not_reviewed} walks there"), parts_.actions)
                 .arg(what));
}

} // namespace espalier
