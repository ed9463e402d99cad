#include "app/window/scan_distances.h"

#include "ui/document/plant_document.h"

#include <utility>

namespace espalier {

ScanDistances::ScanDistances(PlantDocument& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document, &PlantDocument::skeletonEdited, this, &ScanDistances::take);
  connect(&document, &PlantDocument::skeletonReplaced, this, &ScanDistances::measureAnew);
  connect(&document, &PlantDocument::scanChanged, this, &ScanDistances::measureAnew);
  connect(&job_, &JobRunner::finished, this, [this] {
    if (!since_) start();
  });
}

void ScanDistances::setWanted(Use use, bool isWanted) {
  if (isWanted)
    uses_.insert(use);
  else
    uses_.erase(use);
  if (uses_.empty() || (!distances_ && !job_.isRunning())) measureAnew();
}

void ScanDistances::take(const SkeletonDelta& delta) {
  if (uses_.empty()) return;
  if (job_.isRunning()) {
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
  if (job_.isRunning())
    job_.cancel(); // begins again once it is over
  else
    start();
  if (hadSome) emit changed();
}

void ScanDistances::start() {
  const Scan* scan = document_.scan();
  since_ = SkeletonDelta();
  if (uses_.empty() || scan == nullptr || document_.skeleton().isEmpty()) return;
  job_.start(
      tr("Distances to the scan"),
      [cloud = scan->cloud(), spacing = scan->spacing(),
       skeleton = document_.skeleton()](const Progress& progress) {
        return std::make_shared<PointDistances>(cloud, spacing, skeleton, progress);
      },
      [this](std::shared_ptr<PointDistances> measured) {
        if (!since_) return;
        distances_ = std::move(measured);
        if (!since_->isEmpty()) distances_->update(document_.skeleton(), *since_);
        emit changed();
      });
}

} // namespace espalier
