#include "app/window/review/expected_errors_flow.h"

#include "core/base/spatial_index.h"
#include "core/decide/error_ratings.h"
#include "core/graph/turn_upright.h"
#include "core/skeleton/checks_of_scan.h"
#include "ui/document/plant_document.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

struct FoundErrors {
  ErrorRatings ratings;
  std::vector<Finding> clusters;
};

} // namespace

ExpectedErrorsFlow::ExpectedErrorsFlow(const Parts& parts)
    : parts_(parts), job_(parts.queue, JobPriority::background) {
  timer_.setSingleShot(true);
  timer_.setInterval(200); // [ms]: a drag is looked at when it rests
  connect(&timer_, &QTimer::timeout, this, &ExpectedErrorsFlow::refresh);
  PlantDocument& document = parts_.document;
  connect(&document, &PlantDocument::skeletonEdited, this, &ExpectedErrorsFlow::take);
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged,
                      &PlantDocument::leftOutChanged, &PlantDocument::upChanged})
    connect(&document, signal, this, &ExpectedErrorsFlow::dropAll);
  connect(&parts_.distances, &ScanDistances::changed, this, [this] {
    if (!isWanted_) return;
    if (isOutdated_)
      timer_.start();
    else
      emit changed(); // its points are known again, or no longer
  });
  connect(&job_, &JobSlot::failed, this, [this](const QString& message) {
    isOutdated_ = false;
    emit noted(message);
  });
  connect(&job_, &JobSlot::finished, this, &ExpectedErrorsFlow::changed);
}

bool ExpectedErrorsFlow::isBusy() const {
  return isWanted_ && (isOutdated_ || !parts_.distances.now()) &&
         parts_.document.scan() != nullptr && !parts_.document.skeleton().isEmpty();
}

std::optional<ErrorEvidence>
ExpectedErrorsFlow::riskiestOf(const std::vector<NodeId>& nodes) const {
  const auto piece = now() != nullptr ? riskiestPiece(ratings_, nodes) : std::nullopt;
  return piece ? std::optional(ratings_.evidence[*piece]) : std::nullopt;
}

PointSet ExpectedErrorsFlow::pointsOf(const Finding& cluster) const {
  return now() != nullptr ? parts_.distances.inScan(cluster.points) : PointSet();
}

std::vector<NodeId> ExpectedErrorsFlow::nodesAt(const Finding& cluster) const {
  std::vector<NodeId> nodes;
  if (now() == nullptr) return nodes;
  for (const Eigen::Index point : cluster.points)
    nodes.push_back(parts_.distances.now()->nearest()[static_cast<std::size_t>(point)]);
  std::ranges::sort(nodes);
  const auto [first, last] = std::ranges::unique(nodes);
  nodes.erase(first, last);
  return nodes;
}

void ExpectedErrorsFlow::setWanted(bool isWanted) {
  if (isWanted == isWanted_) return;
  isWanted_ = isWanted;
  parts_.distances.setWanted(ScanDistances::Use::review, isWanted);
  if (isWanted) timer_.start(0);
}

void ExpectedErrorsFlow::take(const SkeletonDelta& delta) {
  if (std::ranges::any_of(delta.changes, changesWood)) findAnew();
}

void ExpectedErrorsFlow::findAnew() {
  isOutdated_ = true;
  ++changes_;
  if (isWanted_) timer_.start(200);
}

void ExpectedErrorsFlow::dropAll() {
  const bool hadSome = std::exchange(errors_, std::nullopt).has_value();
  isOutdated_ = true;
  ++changes_;
  job_.cancel();
  if (isWanted_) timer_.start(0);
  if (hadSome) emit changed();
}

void ExpectedErrorsFlow::refresh() {
  const std::shared_ptr<const PointDistances> distances = parts_.distances.now();
  if (!isWanted_ || !isOutdated_ || !distances || parts_.document.scan() == nullptr) return;
  job_.start(
      tr("Where errors are likely"),
      [distances, skeleton = parts_.document.skeleton(), scale = parts_.document.scale(),
       limits = parts_.limits(),
       up = Eigen::Vector3d(turnUpright(parts_.document.up()).row(2).transpose())](
          const Progress& progress) {
        const SpatialIndex index(distances->cloud()->positions(), progress);
        return FoundErrors{
            errorRatings(skeleton, *distances, index, scale, up, progress.part(0, 0.8)),
            pointsWithoutWood(skeleton, *distances, scale.spacing, limits, progress.part(0.8, 1))};
      },
      [this, changes = changes_](FoundErrors found) {
        ratings_ = std::move(found.ratings);
        errors_ = ExpectedErrors{ratings_.ofEdges, std::move(found.clusters)};
        isOutdated_ = changes != changes_; // it was edited meanwhile
      });
}

} // namespace espalier
