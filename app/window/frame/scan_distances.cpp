#include "app/window/frame/scan_distances.h"

#include "ui/document/plant_document.h"

#include <limits>
#include <utility>

namespace espalier {

std::shared_ptr<const PointCloud> pointsWithout(const std::shared_ptr<const PointCloud>& cloud,
                                                const PointSet& leftOut) {
  return leftOut.isEmpty() ? cloud : std::make_shared<const PointCloud>(without(*cloud, leftOut));
}

ScanDistances::ScanDistances(PlantDocument& document, JobQueue& queue)
    : document_(document), job_(queue, JobPriority::background) {
  connect(&document, &PlantDocument::skeletonEdited, this, &ScanDistances::take);
  connect(&document, &PlantDocument::skeletonReplaced, this, &ScanDistances::measureAnew);
  connect(&document, &PlantDocument::scanChanged, this, &ScanDistances::measureAnew);
  connect(&document, &PlantDocument::leftOutChanged, this, &ScanDistances::measureAnew);
  connect(&job_, &JobSlot::finished, this, [this] {
    if (!since_) start();
  });
}

void ScanDistances::setWanted(Use use, bool isWanted) {
  if (isWanted)
    uses_.insert(use);
  else
    uses_.erase(use);
  if (uses_.empty() || (!distances_ && !job_.isBusy())) measureAnew();
}

std::vector<float> ScanDistances::toSurface() const {
  const std::vector<float>& kept = distances_->toSurface();
  if (leftOut_.isEmpty()) return kept;
  const Eigen::Index count = document_.scan()->cloud()->size();
  std::vector<float> all(static_cast<std::size_t>(count), std::numeric_limits<float>::quiet_NaN());
  std::size_t next = 0;
  for (const Eigen::Index point : others(leftOut_, count))
    all[static_cast<std::size_t>(point)] = kept[next++];
  return all;
}

PointSet ScanDistances::inScan(const std::vector<Eigen::Index>& points) const {
  if (leftOut_.isEmpty()) return PointSet::of(points);
  const std::vector<Eigen::Index> all = others(leftOut_, document_.scan()->cloud()->size());
  std::vector<Eigen::Index> result;
  result.reserve(points.size());
  for (const Eigen::Index point : points)
    result.push_back(all[static_cast<std::size_t>(point)]);
  return PointSet::of(result);
}

void ScanDistances::take(const SkeletonDelta& delta) {
  if (uses_.empty()) return;
  if (job_.isBusy()) {
    if (since_) since_ = since_->then(delta);
    return;
  }
  constexpr std::size_t many = 500; // changes that take about as long as to measure anew
  if (!distances_ || delta.changes.size() > many || document_.skeleton().isEmpty())
    return measureAnew();
  if (distances_.use_count() > 1) // a job reads them
    distances_ = std::make_shared<PointDistances>(*distances_);
  distances_->update(document_.skeleton(), delta);
  emit changed();
}

void ScanDistances::measureAnew() {
  const bool hadSome = std::exchange(distances_, nullptr) != nullptr;
  since_.reset();
  if (job_.isBusy())
    job_.cancel(); // begins again once it is over
  else
    start();
  if (hadSome) emit changed();
}

void ScanDistances::start() {
  const Scan* scan = document_.scan();
  since_ = SkeletonDelta();
  if (uses_.empty() || scan == nullptr || document_.skeleton().isEmpty()) return;
  leftOut_ = scan->leftOut();
  job_.start(
      tr("Distances to the scan"),
      [cloud = scan->cloud(), leftOut = leftOut_, spacing = scan->spacing(),
       skeleton = document_.skeleton()](const Progress& progress) {
        return std::make_shared<PointDistances>(pointsWithout(cloud, leftOut), spacing, skeleton,
                                                progress);
      },
      [this](std::shared_ptr<PointDistances> measured) {
        if (!since_) return;
        distances_ = std::move(measured);
        if (!since_->isEmpty()) distances_->update(document_.skeleton(), *since_);
        emit changed();
      });
}

} // namespace espalier
