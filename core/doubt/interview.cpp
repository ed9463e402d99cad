#include "core/doubt/interview.h"

#include "core/base/counted_random.h"
#include "core/skeleton/review_walk.h"

#include <algorithm>
#include <utility>

namespace espalier {

Interview::Interview(std::shared_ptr<const PointCloud> cloud, Skeleton plant, Skeleton reference,
                     const PlantScale& scale, Eigen::Vector3d up, const Options& options,
                     const Progress& progress)
    : cloud_(std::move(cloud)), plant_(std::move(plant)), reference_(std::move(reference)),
      scale_(scale), up_(std::move(up)), options_(options), oracle_(reference_, options.tolerance),
      index_(cloud_->positions(), progress), distances_(cloud_, scale.spacing, plant_, progress) {
  find(progress);
}

void Interview::find(const Progress& progress) {
  found_ = findDoubts(
      plant_, {.distances = distances_, .index = index_, .scale = scale_, .up = up_}, progress);
  std::erase_if(found_, [&](const Doubt& doubt) {
    return std::ranges::any_of(
        answered_, [&](const Doubt& other) { return isSame(doubt, other, 4 * scale_.spacing); });
  });
  doubts_ = learned_.adjusted(found_, scale_.spacing);
}

std::size_t Interview::chosen() const {
  if (options_.order == AskingOrder::byGain) return 0;
  if (options_.order == AskingOrder::random) {
    CountedRandom random(options_.seed, answered_.size());
    const auto at =
        static_cast<std::size_t>(random.uniform() * static_cast<double>(doubts_.size()));
    return std::min(at, doubts_.size() - 1);
  }
  std::vector<std::size_t> place(plant_.idEnd(), 0);
  std::size_t next = 0;
  for (const Axis& axis : axesInWalkOrder(plant_))
    for (const NodeId id : axis)
      place[indexOf(id)] = next++;
  const auto first = std::ranges::min_element(
      doubts_, {}, [&](const Doubt& one) { return place[indexOf(one.node)]; });
  return static_cast<std::size_t>(first - doubts_.begin());
}

bool Interview::askNext(const Progress& progress) {
  if (doubts_.empty()) return false;
  const std::size_t at = chosen();
  const Doubt doubt = doubts_[at];
  const std::size_t answer = oracle_.answer(plant_, doubt);
  const bool isChanged = answer != doubt.present;
  const auto fitted =
      std::ranges::find_if(found_, [&](const Doubt& other) { return isSame(doubt, other, 0); });
  if (options_.learns) learned_.learn(learnedFrom(*fitted, isChanged, scale_.spacing));
  found_.erase(fitted);
  SkeletonEditor editor(plant_);
  settle(editor, doubt, doubt.alternatives[answer], "reference");
  const SkeletonDelta delta = editor.commit();
  answered_.push_back(doubt);
  if (!isChanged) {
    doubts_ = learned_.adjusted(found_, scale_.spacing);
    return true;
  }
  ++changes_;
  distances_.update(plant_, delta);
  find(progress);
  return true;
}

void Interview::decideRest(const Progress& progress) {
  SkeletonEditor editor(plant_);
  changes_ += decideByOdds(editor, doubts_).size();
  distances_.update(plant_, editor.commit());
  find(progress);
}

ExpectedAgreement Interview::expected(const Progress& progress) const {
  return expectedAgreement(plant_, errorRatings(plant_, distances_, index_, scale_, up_, progress),
                           doubts_);
}

} // namespace espalier
