#include "app/cli/doubt_numbers.h"

#include "core/cloud/point_set.h"
#include "core/doubt/expected_agreement.h"
#include "core/doubt/find_doubts.h"
#include "core/graph/turn_upright.h"

#include <nlohmann/json.hpp>

namespace espalier {
namespace {

const char* nameOf(Alternative::Kind kind) {
  switch (kind) {
  case Alternative::Kind::asItIs:
    return "as_it_is";
  case Alternative::Kind::remove:
    return "remove";
  case Alternative::Kind::attach:
    return "attach";
  case Alternative::Kind::add:
    return "add";
  }
  return "";
}

nlohmann::ordered_json toJson(const Doubt& doubt, const Skeleton& skeleton) {
  auto alternatives = nlohmann::ordered_json::array();
  for (const Alternative& one : doubt.alternatives) {
    nlohmann::ordered_json json = {{"kind", nameOf(one.kind)}, {"probability", one.probability}};
    if (one.onto) json["onto"] = indexOf(*one.onto);
    alternatives.push_back(std::move(json));
  }
  const Eigen::Vector3d& place = skeleton[doubt.node].position;
  return {{"kind", nameOf(doubt.kind)},
          {"node", indexOf(doubt.node)},
          {"place", {place.x(), place.y(), place.z()}},
          {"length", doubt.length},
          {"gain", doubt.gain},
          {"present", doubt.present},
          {"alternatives", std::move(alternatives)}};
}

} // namespace

nlohmann::ordered_json doubtNumbers(const std::shared_ptr<const PointCloud>& cloud,
                                    const Reconstruction& result, UpAxis up,
                                    const Progress& progress) {
  const Skeleton& skeleton = *result.skeleton;
  if (skeleton.size() < 2 || !(result.scale.spacing > 0)) return nullptr;
  const auto points =
      result.apart ? std::make_shared<const PointCloud>(without(*cloud, *result.apart)) : cloud;
  const SpatialIndex index(points->positions(), progress);
  const PointDistances distances(points, result.scale.spacing, skeleton, progress.part(0, 0.2));
  const Eigen::Vector3d upward = turnUpright(up).row(2).transpose();
  const std::vector<Doubt> doubts = findDoubts(
      skeleton, {.distances = distances, .index = index, .scale = result.scale, .up = upward},
      progress.part(0.2, 0.6));
  const ErrorRatings ratings =
      errorRatings(skeleton, distances, index, result.scale, upward, progress.part(0.6, 1));
  nlohmann::ordered_json answers = nlohmann::ordered_json::object();
  for (const char* goal : {"0.9", "0.95", "0.98"}) {
    const std::size_t needed = answersFor(std::stod(goal), skeleton, ratings, doubts);
    answers[goal] =
        needed > doubts.size() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(needed);
  }
  auto list = nlohmann::ordered_json::array();
  for (const Doubt& doubt : doubts)
    list.push_back(toJson(doubt, skeleton));
  return {{"expected_right", expectedAgreement(skeleton, ratings, doubts).share()},
          {"answers_for", std::move(answers)},
          {"count", doubts.size()},
          {"doubts", std::move(list)}};
}

} // namespace espalier
